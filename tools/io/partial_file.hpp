// Files under construction, which do not outlive the program.
//
// A file is written under `path.partial-<pid>` in its own folder. Whoever ends it early (an error,
// SIGINT, SIGTERM, SIGHUP, SIGPIPE, SIGQUIT) removes it. Only SIGKILL and a power cut leave one.
#pragma once

#include <filesystem>

namespace umbra78::tools {

// At the program's start. Signals that are ignored stay so. SIGXFSZ is ignored from here on: a
// write beyond the limit of a file's size then fails as any other.
void remove_partial_files_on_signals();

// The name of a file under construction. The destructor removes the file, unless it was renamed.
class PartialFile {
public:
    explicit PartialFile(const std::filesystem::path& of);
    PartialFile(PartialFile&& other) noexcept;
    PartialFile& operator=(PartialFile&&) = delete;
    ~PartialFile();

    const char* name() const;
    bool rename_to(const std::filesystem::path&);  // false: errno says why

    struct Entry;

private:
    Entry* entry_;
};

}  // namespace umbra78::tools
