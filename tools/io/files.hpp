// Writes PGM, NPY and PNG files; reads PGM and grey PNG.
//
// A file is written under `path.partial-<pid>` in the same folder, flushed, then renamed over
// `path`: a reader sees the old file or the new one, and a failure leaves nothing behind. Files
// that belong together are written into a FileSet; when it is committed they are renamed one
// directly after another. tools/io/destination.hpp says what may be written to, and what is written
// in place. Every error but read_png_gray()'s is a std::runtime_error of one line that names the
// file, what is wrong and what to do. Pictures are rows from the top, width * height samples.
// Colour spaces are ignored: a sample is the machine's grey level.
#pragma once

#include "tools/io/destination.hpp"
#include "tools/io/partial_file.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace umbra78::tools {

// Files that appear when it is committed, or not at all if it is destroyed before.
class FileSet {
public:
    FileSet() = default;
    FileSet(const FileSet&) = delete;
    FileSet& operator=(const FileSet&) = delete;
    ~FileSet();

    // Makes the folder and those above it where they are missing.
    void make_folder(const Path&);
    // Under its partial name; what is written in place is kept until the commit. A file that the
    // set holds already is an error.
    void write(const Path&, std::span<const std::byte> content);
    void commit();

private:
    struct Written {
        Destination to;
        PartialFile partial;
    };
    struct Kept {
        Destination to;
        std::vector<std::byte> content;
    };
    std::vector<Path> folders_;
    std::vector<Written> written_;
    std::vector<Kept> kept_;
};

// A file that is too long to be held: written piece by piece under its partial name, or in place.
// Unless it is committed, nothing stays of what was not written in place.
class LongFile {
public:
    explicit LongFile(const Path&);
    LongFile(const LongFile&) = delete;
    LongFile& operator=(const LongFile&) = delete;
    ~LongFile();

    void write(std::span<const std::byte>);
    void commit();

private:
    Destination to_;
    std::optional<PartialFile> partial_;  // none where it is written in place
    int file_;
};

// Every writer below puts its file into `set`, or where there is none, in its place at once.
void write_file(const Path&, std::span<const std::byte> content, FileSet* set = nullptr);

// PGM, binary (P5), maxval 1 .. 65535. By the format's definition a sample takes one byte if
// maxval < 256, otherwise two, the higher first. A sample above maxval is an error.
void write_pgm8(const Path&, int width, int height, std::span<const std::uint8_t>,
                int maxval = 255, FileSet* set = nullptr);
void write_pgm16(const Path&, int width, int height, std::span<const std::uint16_t>,
                 int maxval = 65535, FileSet* set = nullptr);
void write_pgm16(const Path&, int width, int height, std::span<const std::uint32_t>,
                 int maxval = 65535, FileSet* set = nullptr);

struct Pgm {
    int width, height, maxval;
    std::vector<std::uint16_t> samples;  // 0 .. maxval
};

// One picture of at most 2^28 pixels, with comments; anything after it is an error.
Pgm read_pgm(const Path&);

// NPY, version 1.0: a C-ordered array of shape (height, width), dtype |u1, <u2 or <u4.
void write_npy(const Path&, int width, int height, std::span<const std::uint8_t>,
               FileSet* set = nullptr);
void write_npy(const Path&, int width, int height, std::span<const std::uint16_t>,
               FileSet* set = nullptr);
void write_npy(const Path&, int width, int height, std::span<const std::uint32_t>,
               FileSet* set = nullptr);

// PNG, 8 bits a channel. Never hash these bytes: they depend on the compressor.
void write_png_gray(const Path&, int width, int height, std::span<const std::uint8_t>,
                    FileSet* set = nullptr);
void write_png_rgb(const Path&, int width, int height, std::span<const std::uint8_t>,
                   FileSet* set = nullptr);
std::vector<std::byte> png_gray(int width, int height, std::span<const std::uint8_t>);

struct GrayPng {
    int width, height;
    std::vector<std::uint8_t> samples;
};

// Nothing where there is no such file, or it is no whole PNG of 8-bit gray.
std::optional<GrayPng> read_png_gray(const Path&);

}  // namespace umbra78::tools
