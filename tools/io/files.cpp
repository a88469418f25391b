#include "tools/io/files.hpp"

#include "tools/io/console.hpp"
#include "tools/io/file_errors.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <fstream>
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

// The open descriptor of a file.
struct Opened {
    int number;
    explicit Opened(int of) : number(of) {}
    Opened(Opened&& other) noexcept : number(std::exchange(other.number, -1)) {}
    Opened& operator=(Opened&&) = delete;
    int release() { return std::exchange(number, -1); }
    ~Opened() {
        if (number >= 0) ::close(number);
    }
};

void write_all(int file, const Destination& to, std::span<const std::byte> content) {
    while (!content.empty()) {
        const ssize_t written = ::write(file, content.data(), content.size());
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) fail_to_write(to.named, errno);
        content = content.subspan(static_cast<std::size_t>(written));
    }
}

// A file that replaces another has its mode and, where that is allowed, its owner.
Opened open_partial(const PartialFile& partial, const Destination& to) {
    ::unlink(partial.name());  // of a process that was killed and had the same number
    Opened file{::open(partial.name(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC,
                       to.now ? 0600 : 0666)};
    if (file.number < 0) fail_to_write(to.named, errno);
    if (to.now) {
        const bool owned = ::fchown(file.number, to.now->st_uid, to.now->st_gid) == 0;
        const mode_t kept = owned ? 07777 : 0777;  // no set-user-ID for another owner
        if (::fchmod(file.number, to.now->st_mode & kept) != 0) fail_to_write(to.named, errno);
    }
    return file;
}

void close_written(int& file, const Destination& to) {
    if (::close(std::exchange(file, -1)) != 0) fail_to_write(to.named, errno);
}

void write_partial(const PartialFile& partial, const Destination& to,
                   std::span<const std::byte> content) {
    Opened file = open_partial(partial, to);
    write_all(file.number, to, content);
    close_written(file.number, to);
}

Opened open_in_place(const Destination& to) {
    Opened file{::open(to.path.c_str(), O_WRONLY | O_NOCTTY | O_CLOEXEC)};
    if (file.number < 0) fail_to_write(to.named, errno);
    return file;
}

void write_in_place(const Destination& to, std::span<const std::byte> content) {
    if (to.kind == Destination::Kind::standard_output)
        return write_all(standard_output(), to, content);
    write_all(open_in_place(to).number, to, content);
}

}  // namespace

FileSet::~FileSet() {
    written_.clear();  // removes the partial files, so that the folders are empty
    std::error_code ignored;
    for (const Path& path : folders_) std::filesystem::remove(path, ignored);  // if empty
}

void FileSet::make_folder(const Path& path) {
    std::error_code error;
    std::vector<Path> made;  // the innermost first, and before those of earlier calls
    for (Path missing = std::filesystem::absolute(path).lexically_normal();
         !std::filesystem::exists(missing, error) && missing.has_relative_path();
         missing = missing.parent_path())
        made.push_back(missing);
    folders_.insert(folders_.begin(), made.begin(), made.end());
    std::filesystem::create_directories(path, error);
    if (!error && !std::filesystem::is_directory(path))
        error = std::make_error_code(std::errc::not_a_directory);
    if (error) fail_to_make(path, error.value());
}

void FileSet::write(const Path& path, std::span<const std::byte> content) {
    Destination to = destination_of(path);
    if (to.kind != Destination::Kind::file) {
        kept_.push_back({std::move(to), {content.begin(), content.end()}});
        return;
    }
    for (const Written& w : written_)
        if (w.to.path == to.path)
            fail_to_write(path, "another output of this command has this name", "name another");
    PartialFile partial(to.path);
    write_partial(partial, to, content);
    written_.push_back({std::move(to), std::move(partial)});
}

// What cannot be taken back comes first: if it fails, no file appears.
void FileSet::commit() {
    for (const Kept& k : kept_) write_in_place(k.to, k.content);
    kept_.clear();
    for (Written& w : written_)
        if (!w.partial.rename_to(w.to.path)) fail_to_write(w.to.named, errno);
    written_.clear();
    folders_.clear();
}

LongFile::LongFile(const Path& path) : to_(destination_of(path)), file_(-1) {
    if (to_.kind == Destination::Kind::file) {
        partial_.emplace(to_.path);
        file_ = open_partial(*partial_, to_).release();
    } else {
        file_ = to_.kind == Destination::Kind::standard_output ? ::dup(standard_output())
                                                               : open_in_place(to_).release();
        if (file_ < 0) fail_to_write(to_.named, errno);
    }
}

LongFile::~LongFile() {
    if (file_ >= 0) ::close(file_);
}

void LongFile::write(std::span<const std::byte> content) { write_all(file_, to_, content); }

void LongFile::commit() {
    close_written(file_, to_);
    if (partial_ && !partial_->rename_to(to_.path)) fail_to_write(to_.named, errno);
}

void write_file(const Path& path, std::span<const std::byte> content, FileSet* set) {
    FileSet alone;
    (set ? *set : alone).write(path, content);
    alone.commit();
}

void fail_to_write(const Path& path, std::string_view wrong, std::string_view remedy) {
    fail("write", path, wrong, remedy);
}

void fail_to_write(const Path& path, int error) {
    const char* remedy = error == ENOENT ? "create its folder first"
                         : error == ENOSPC || error == EDQUOT ? "free some space there"
                         : error == EFBIG  ? "raise the limit of a file's size (ulimit -f)"
                         : error == ENAMETOOLONG ? "give it a shorter name"
                         : error == EISDIR ? "name a file, not a folder"
                                           : "name a place that can be written to";
    fail_to_write(path, std::generic_category().message(error), remedy);
}

void fail_to_make(const Path& folder, int error) {
    fail("make the folder", folder, std::generic_category().message(error),
         "name a place that can be written to");
}

void fail_to_read(const Path& path, std::string_view wrong, std::string_view remedy) {
    fail("read", path, wrong, remedy);
}
void fail_to_read(const Path& path, std::string_view wrong) {
    fail_to_read(path, wrong, pgm_remedy);
}

std::string read_bytes(const Path& path, std::string_view remedy) {
    std::error_code error;
    if (!std::filesystem::exists(path, error))
        fail_to_read(path, "there is no such file", remedy);
    if (!std::filesystem::is_regular_file(path, error))
        fail_to_read(path, "it is not a file", remedy);
    std::ifstream file(path, std::ios::binary);
    std::string bytes(std::filesystem::file_size(path, error), '\0');
    if (error || !file.read(bytes.data(), static_cast<std::streamsize>(bytes.size())))
        fail_to_read(path, "it cannot be opened or read", remedy);
    return bytes;
}

std::string why_not_read(const Path& path) {
    const Opened file{::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK)};
    struct stat its {};
    if (file.number < 0 || ::fstat(file.number, &its) != 0)
        return std::generic_category().message(errno);
    return S_ISDIR(its.st_mode) ? std::generic_category().message(EISDIR) : "";
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
