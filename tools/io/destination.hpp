// Where an output goes, and whether it may go there: nothing that exists is destroyed by mistake.
//
// A link is followed. A regular file is replaced as a whole and keeps its mode and owner. A pipe, a
// terminal or a character device is written in place. "-" is standard output, and so is a file or a
// pipe that standard output leads to. Refused are folders, disks, write-protected files, and every
// input of the command, by whatever name or link.
// Errors are std::runtime_error of one line: the file, what is wrong, what to do.
#pragma once

#include <sys/stat.h>

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace umbra78::tools {

using Path = std::filesystem::path;

struct Destination {
    enum class Kind { file, in_place, standard_output };
    Kind kind;
    Path named;                      // as it was given, for messages
    Path path;                       // without links
    std::optional<struct stat> now;  // of what is there
};

Destination destination_of(const Path&);

// An input of the command: no output is written to it. One that does not exist is not an input.
void note_input(const Path&);

// Before the work: throws what making the folder, or writing into it, would throw later.
void check_folder(const Path&);

// Before the work: throws what writing the file would throw later, as far as it can be known.
// `ending` is that of the file's format (".png"): a name without an ending is taken, too. The
// folder of the file exists, or is in one of `folders`, which are made before the file.
Destination::Kind check_output(const Path&, std::string_view ending,
                               std::span<const std::string> folders);

}  // namespace umbra78::tools
