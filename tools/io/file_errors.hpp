// What the readers and writers of file formats share: errors of one line, and checks of sizes.
#pragma once

#include "tools/io/files.hpp"

#include <string>
#include <string_view>

namespace umbra78::tools {

[[noreturn]] void fail_to_write(const Path&, std::string_view wrong, std::string_view remedy);
[[noreturn]] void fail_to_write(const Path&, int error);  // of errno
[[noreturn]] void fail_to_make(const Path& folder, int error);
inline constexpr std::string_view pgm_remedy = "give a binary PGM (P5) of 8 or 16 bits";
[[noreturn]] void fail_to_read(const Path&, std::string_view wrong);  // of a PGM
[[noreturn]] void fail_to_read(const Path&, std::string_view wrong, std::string_view remedy);
// All of a file; a folder, a pipe or a device has no size of its own and is refused.
std::string read_bytes(const Path&, std::string_view remedy);

// Why a file cannot be read, as the system says it: "Is a directory". "" if it can be.
std::string why_not_read(const Path&);

// Throws unless there are width * height samples of `channels` values.
void expect_samples(const Path&, int width, int height, std::size_t samples,
                    std::size_t channels = 1);

void append(std::vector<std::byte>& bytes, std::string_view text);

}  // namespace umbra78::tools
