#include "tools/io/files.hpp"

#include "tools/io/file_errors.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <stdexcept>
#include <string>
#include <system_error>
#include <utility>

namespace umbra78::tools {
namespace {

[[noreturn]] void fail(const char* doing, const Path& path, std::string_view wrong,
                       std::string_view remedy) {
    throw std::runtime_error(
        fmt::format("cannot {} '{}': {}; {}", doing, path.string(), wrong, remedy));
}

[[noreturn]] void fail_with(int error, const Path& path) {
    const char* remedy = error == ENOENT   ? "create its folder first"
                         : error == ENOSPC ? "free some space there"
                         : error == EISDIR ? "name a file, not a folder"
                                           : "name a place that can be written to";
    fail_to_write(path, std::generic_category().message(error), remedy);
}

Path partial_name(const Path& path) {
    return path.string() + fmt::format(".partial-{}", getpid());
}

// An open file that is removed unless it is kept.
struct Partial {
    Path path;
    std::FILE* file;
    bool kept = false;

    ~Partial() {
        if (file) std::fclose(file);
        if (!kept) std::remove(path.c_str());
    }
};

void write_partial(const Path& path, std::span<const std::byte> content) {
    std::error_code ignored;
    if (std::filesystem::is_directory(path, ignored)) fail_with(EISDIR, path);
    const Path name = partial_name(path);
    std::FILE* file = std::fopen(name.c_str(), "wb");
    if (!file) fail_with(errno, path);
    Partial partial{name, file};
    const bool written = std::fwrite(content.data(), 1, content.size(), file) == content.size();
    if (!written || std::fflush(file) != 0) fail_with(errno, path);
    if (std::fclose(std::exchange(partial.file, nullptr)) != 0) fail_with(errno, path);
    partial.kept = true;
}

}  // namespace

FileSet::~FileSet() {
    std::error_code ignored;
    for (const Path& path : written_) std::remove(partial_name(path).c_str());
    for (const Path& path : folders_) std::filesystem::remove(path, ignored);  // if empty
}

void FileSet::make_folder(const Path& path) {
    std::error_code error;
    for (Path missing = std::filesystem::absolute(path).lexically_normal();
         !std::filesystem::exists(missing, error) && missing.has_relative_path();
         missing = missing.parent_path())
        folders_.push_back(missing);
    std::filesystem::create_directories(path, error);
    if (!error && !std::filesystem::is_directory(path))
        error = std::make_error_code(std::errc::not_a_directory);
    if (error)
        fail("make the folder", path, error.message(), "name a place that can be written to");
}

void FileSet::write(const Path& path, std::span<const std::byte> content) {
    write_partial(path, content);
    written_.push_back(path);
}

void FileSet::commit() {
    for (const Path& path : written_)
        if (std::rename(partial_name(path).c_str(), path.c_str()) != 0) fail_with(errno, path);
    written_.clear();
    folders_.clear();
}

void write_file(const Path& path, std::span<const std::byte> content, FileSet* set) {
    FileSet alone;
    (set ? *set : alone).write(path, content);
    alone.commit();
}

void fail_to_write(const Path& path, std::string_view wrong, std::string_view remedy) {
    fail("write", path, wrong, remedy);
}

void fail_to_read(const Path& path, std::string_view wrong) {
    fail("read", path, wrong, "give a binary PGM (P5) of 8 or 16 bits");
}

void expect_samples(const Path& path, int width, int height, std::size_t samples,
                    std::size_t channels) {
    if (width < 1 || height < 1)
        fail_to_write(path, fmt::format("a picture of {} x {} pixels", width, height),
                      "width and height must be at least 1");
    const std::size_t needed = channels * static_cast<std::size_t>(width) * height;
    if (samples != needed)
        fail_to_write(path, fmt::format("{} samples for {} x {} pixels", samples, width, height),
                      fmt::format("hand in {}", needed));
}

void append(std::vector<std::byte>& bytes, std::string_view text) {
    const auto raw = std::as_bytes(std::span(text));
    bytes.insert(bytes.end(), raw.begin(), raw.end());
}

}  // namespace umbra78::tools
