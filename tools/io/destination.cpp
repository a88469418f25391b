#include "tools/io/destination.hpp"

#include "tools/io/console.hpp"
#include "tools/io/file_errors.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <string>
#include <vector>

namespace umbra78::tools {
namespace {

std::vector<Path> inputs;
// Names like /dev/stdout, which lead elsewhere once standard output is taken.
std::vector<Path> names_of_standard_output{"-"};

bool are_same(const struct stat& a, const struct stat& b) {
    return a.st_dev == b.st_dev && a.st_ino == b.st_ino;
}

// Devices may be both: reading /dev/null and writing to it destroys nothing.
bool is_input(const struct stat& output) {
    return !S_ISCHR(output.st_mode) &&
           std::any_of(inputs.begin(), inputs.end(), [&](const Path& path) {
               struct stat input {};
               return ::stat(path.c_str(), &input) == 0 && are_same(input, output);
           });
}

bool is_standard_output(const struct stat& output) {
    struct stat its {};
    return !S_ISCHR(output.st_mode) && ::fstat(standard_output(), &its) == 0 &&
           are_same(its, output);
}

// Where a link leads whose target does not exist: a file that will be made there. One file has one
// such path.
Path end_of_links(Path path) {
    constexpr int max_links = 40;
    std::error_code none;
    for (int k = 0; k < max_links; ++k) {
        const Path target = std::filesystem::read_symlink(path, none);
        if (none) break;
        path = path.parent_path() / target;  // an absolute target replaces all
    }
    const Path folder = path.has_parent_path() ? path.parent_path() : Path(".");
    const Path real = std::filesystem::canonical(folder, none);
    return none || !path.has_filename() ? path : real / path.filename();
}

bool is_in(const Path& path, const Path& folder) {
    const auto whole = [](const Path& p) {
        Path full = std::filesystem::absolute(p).lexically_normal();
        return full.has_filename() ? full : full.parent_path();
    };
    const Path inner = whole(path), outer = whole(folder);
    return std::mismatch(outer.begin(), outer.end(), inner.begin(), inner.end()).first ==
           outer.end();
}

void check_ending(const Path& path, std::string_view ending) {
    std::string its = path.extension().string();
    std::transform(its.begin(), its.end(), its.begin(),
                   [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
    if (its.empty() || its == ending) return;
    fail_to_write(path,
                  fmt::format("it would not be a {} file: {} is the only format", its, ending),
                  fmt::format("name it '{}'", Path(path).replace_extension(ending).string()));
}

}  // namespace

Destination destination_of(const Path& path) {
    using Kind = Destination::Kind;
    const std::vector<Path>& names = names_of_standard_output;
    if (std::find(names.begin(), names.end(), path) != names.end())
        return {Kind::standard_output, path, path, {}};
    struct stat now {};
    if (::stat(path.c_str(), &now) != 0) {
        if (errno != ENOENT) fail_to_write(path, errno);
        const Path end = end_of_links(path);
        if (!end.has_filename()) fail_to_write(path, path.empty() ? ENOENT : EISDIR);
        return {Kind::file, path, end, {}};
    }
    if (S_ISDIR(now.st_mode)) fail_to_write(path, EISDIR);
    if (is_input(now)) fail_to_write(path, "it is an input of this command", "name another file");
    if (is_standard_output(now)) return {Kind::standard_output, path, path, now};
    if (S_ISBLK(now.st_mode)) fail_to_write(path, "it is a disk", "name a file");
    if (!S_ISREG(now.st_mode)) return {Kind::in_place, path, path, now};
    if (::faccessat(AT_FDCWD, path.c_str(), W_OK, AT_EACCESS) != 0) fail_to_write(path, errno);
    std::error_code error;
    const Path target = std::filesystem::canonical(path, error);
    if (error) fail_to_write(path, error.value());
    return {Kind::file, path, target, now};
}

void check_folder(const Path& folder) {
    std::error_code none;
    Path there = std::filesystem::absolute(folder).lexically_normal();
    while (!std::filesystem::exists(there, none) && there.has_relative_path())
        there = there.parent_path();
    const bool made = std::filesystem::exists(folder, none);
    if (!std::filesystem::is_directory(there, none)) fail_to_make(folder, ENOTDIR);
    if (::faccessat(AT_FDCWD, there.c_str(), W_OK | X_OK, AT_EACCESS) == 0) return;
    made ? fail_to_write(folder, errno) : fail_to_make(folder, errno);
}

void note_input(const Path& path) { inputs.push_back(path); }

Destination::Kind check_output(const Path& path, std::string_view ending,
                               std::span<const std::string> folders) {
    const Destination to = destination_of(path);
    if (to.kind == Destination::Kind::standard_output) names_of_standard_output.push_back(path);
    if (to.kind == Destination::Kind::standard_output && ending == ".png" &&
        ::isatty(standard_output()))
        fail_to_write(path, "standard output is a terminal", "redirect it to a file or a pipe");
    if (to.kind != Destination::Kind::file) return to.kind;
    check_ending(path, ending);
    Path folder = to.path.parent_path();
    if (folder.empty()) folder = ".";
    const auto made = [&](const std::string& f) { return !f.empty() && is_in(folder, f); };
    std::error_code none;
    if (std::none_of(folders.begin(), folders.end(), made) &&
        !std::filesystem::is_directory(folder, none))
        fail_to_write(path, std::filesystem::exists(folder, none) ? ENOTDIR : ENOENT);
    if (std::filesystem::exists(folder, none) &&
        ::faccessat(AT_FDCWD, folder.c_str(), W_OK | X_OK, AT_EACCESS) != 0)
        fail_to_write(path, errno);
    return to.kind;
}

}  // namespace umbra78::tools
