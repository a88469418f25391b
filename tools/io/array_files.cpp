// Files of plain arrays of numbers: PGM pictures and NPY arrays.
//
// PGM, binary (netpbm's P5): "P5", width, height and maxval in decimal, one white space, then the
// samples.
// NPY 1.0 (numpy/lib/format.py): magic, version, header length, then a dictionary padded so that
// the data starts at a multiple of 64 bytes, then the samples, low byte first.
#include "tools/io/file_errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstring>
#include <string>

namespace umbra78::tools {
namespace {

constexpr int pgm_max_pixels = 1 << 28;  // half a gigabyte of samples

template <class Sample>
void write_pgm(const Path& path, int width, int height, std::span<const Sample> samples,
               int maxval, FileSet* set) {
    expect_samples(path, width, height, samples.size());
    if (maxval < 1 || maxval > 65535)
        fail_to_write(path, fmt::format("maxval {}", maxval), "PGM allows 1 .. 65535");
    std::vector<std::byte> bytes;
    bytes.reserve(32 + 2 * samples.size());
    append(bytes, fmt::format("P5\n{} {}\n{}\n", width, height, maxval));
    for (std::size_t at = 0; at < samples.size(); ++at) {
        const std::uint32_t sample = samples[at];
        if (sample > static_cast<std::uint32_t>(maxval))
            fail_to_write(path,
                          fmt::format("sample {} at x {}, y {} is above maxval {}", sample,
                                      at % width, at / width, maxval),
                          "scale it down, or write NPY");
        if (maxval > 255) bytes.push_back(static_cast<std::byte>(sample >> 8));
        bytes.push_back(static_cast<std::byte>(sample & 0xFF));
    }
    write_file(path, bytes, set);
}

template <class Sample>
void write_npy_of(const Path& path, int width, int height, std::span<const Sample> samples,
                  const char* dtype, FileSet* set) {
    constexpr std::size_t preamble = 10, alignment = 64;
    expect_samples(path, width, height, samples.size());
    std::string header =
        fmt::format("{{'descr': '{}', 'fortran_order': False, 'shape': ({}, {}), }}", dtype,
                    height, width);
    const std::size_t used = (preamble + header.size() + 1) % alignment;
    header.append((alignment - used) % alignment, ' ').push_back('\n');

    std::vector<std::byte> bytes;
    bytes.reserve(preamble + header.size() + sizeof(Sample) * samples.size());
    append(bytes, "\x93NUMPY\x01");
    bytes.push_back(std::byte{0});
    bytes.push_back(static_cast<std::byte>(header.size() & 0xFF));
    bytes.push_back(static_cast<std::byte>(header.size() >> 8));
    append(bytes, header);
    for (const std::uint32_t sample : samples)
        for (std::size_t byte = 0; byte < sizeof(Sample); ++byte)
            bytes.push_back(static_cast<std::byte>(sample >> (8 * byte) & 0xFF));
    write_file(path, bytes, set);
}

}  // namespace

void write_pgm8(const Path& path, int width, int height, std::span<const std::uint8_t> samples,
                int maxval, FileSet* set) {
    if (maxval > 255) fail_to_write(path, fmt::format("maxval {}", maxval), "8 bits hold 255");
    write_pgm(path, width, height, samples, maxval, set);
}

void write_pgm16(const Path& path, int width, int height,
                 std::span<const std::uint16_t> samples, int maxval, FileSet* set) {
    write_pgm(path, width, height, samples, maxval, set);
}

void write_pgm16(const Path& path, int width, int height,
                 std::span<const std::uint32_t> samples, int maxval, FileSet* set) {
    write_pgm(path, width, height, samples, maxval, set);
}

Pgm read_pgm(const Path& path) {
    const std::string bytes = read_bytes(path, pgm_remedy);
    std::size_t at = 2;
    const auto space = [&] { return at < bytes.size() && std::strchr(" \t\n\v\f\r", bytes[at]); };
    const auto number = [&](const char* name, int max) {
        const std::size_t before = at;
        while (space() || (at < bytes.size() && bytes[at] == '#'))
            at = bytes[at] == '#' ? std::min(bytes.find('\n', at), bytes.size()) : at + 1;
        int value = 0;
        const char* first = bytes.data() + at;
        const auto [end, error] = std::from_chars(first, bytes.data() + bytes.size(), value);
        if (at == before || error != std::errc{} || value < 1 || value > max)
            fail_to_read(path, fmt::format("its {} is not a number from 1 to {}", name, max));
        at += static_cast<std::size_t>(end - first);
        return value;
    };

    if (!bytes.starts_with("P5")) fail_to_read(path, "it does not begin with 'P5'");
    Pgm picture{};
    picture.width = number("width", pgm_max_pixels);
    picture.height = number("height", pgm_max_pixels / picture.width);
    picture.maxval = number("maxval", 65535);
    if (!space()) fail_to_read(path, "no white space follows its maxval");
    ++at;

    const std::size_t wide = picture.maxval > 255 ? 2 : 1;
    const std::size_t pixels = static_cast<std::size_t>(picture.width) * picture.height;
    if (bytes.size() - at != wide * pixels)
        fail_to_read(path, fmt::format("{} bytes of samples where {} x {} pixels need {}",
                                       bytes.size() - at, picture.width, picture.height,
                                       wide * pixels));
    picture.samples.resize(pixels);
    for (std::size_t pixel = 0; pixel < pixels; ++pixel) {
        int sample = static_cast<unsigned char>(bytes[at++]);
        if (wide == 2) sample = sample << 8 | static_cast<unsigned char>(bytes[at++]);
        if (sample > picture.maxval)
            fail_to_read(path, fmt::format("sample {} at x {}, y {} is above its maxval {}",
                                           sample, pixel % picture.width,
                                           pixel / picture.width, picture.maxval));
        picture.samples[pixel] = static_cast<std::uint16_t>(sample);
    }
    return picture;
}

void write_npy(const Path& path, int width, int height, std::span<const std::uint8_t> samples,
               FileSet* set) {
    write_npy_of(path, width, height, samples, "|u1", set);
}

void write_npy(const Path& path, int width, int height, std::span<const std::uint16_t> samples,
               FileSet* set) {
    write_npy_of(path, width, height, samples, "<u2", set);
}

void write_npy(const Path& path, int width, int height, std::span<const std::uint32_t> samples,
               FileSet* set) {
    write_npy_of(path, width, height, samples, "<u4", set);
}

}  // namespace umbra78::tools
