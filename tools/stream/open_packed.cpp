// Opening a packed file: by its path or from standard input, and the copy of what is read once.
#include "tools/stream/packed.hpp"

#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <system_error>

namespace umbra78::tools {
namespace {

using File = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

// A temporary file without a name, which ends with its handle.
File temporary_file(const std::filesystem::path& folder) {
    std::string name = (folder / "umbra78-XXXXXX").string();
    const int file = ::mkstemp(name.data());
    if (file < 0) return {nullptr, std::fclose};
    ::unlink(name.c_str());
    return {::fdopen(file, "w+b"), std::fclose};
}

File spooled(std::FILE* from, std::string& error) {
    const char* named = std::getenv("TMPDIR");
    const std::filesystem::path folder = named != nullptr && *named != 0 ? named : "/tmp";
    File to = temporary_file(folder);
    std::array<char, 1 << 16> block;
    while (to) {
        const std::size_t got = std::fread(block.data(), 1, block.size(), from);
        if (got == 0 && !std::ferror(from) && std::fflush(to.get()) == 0 &&
            std::fseek(to.get(), 0, SEEK_SET) == 0)
            return to;
        if (got == 0 || std::fwrite(block.data(), 1, got, to.get()) != got) break;
    }
    const std::string why = std::generic_category().message(errno);
    error = std::ferror(from)
                ? why + "; give a packed file, or the pipe of one"
                : fmt::format("its copy in {}: {}; set TMPDIR to a folder with room for it",
                              folder.string(), why);
    return {nullptr, std::fclose};
}

}  // namespace

OpenedStream open_packed(const std::string& path, bool spool) {
    const bool standard_input = path == "-";
    const std::string name = standard_input ? "standard input" : path;
    const auto refuse = [&](const std::string& why) {
        return OpenedStream{nullptr, fmt::format("cannot read {}: {}", name, why)};
    };
    File file(standard_input ? stdin : std::fopen(path.c_str(), "rb"), std::fclose);
    struct stat its {};
    if (!file || ::fstat(::fileno(file.get()), &its) != 0)
        return refuse(std::generic_category().message(errno) + "; give the path of a packed file");
    if (S_ISDIR(its.st_mode)) return refuse("it is a folder; give the path of a packed file");
    bool can_rewind = S_ISREG(its.st_mode);
    if (!can_rewind && spool) {
        std::string error;
        file = spooled(file.get(), error);
        if (!file) return refuse(error);
        can_rewind = true;
    }
    return open_packed(file.release(), name, can_rewind);
}

}  // namespace umbra78::tools
