// NPY 1.0 (numpy/lib/format.py): magic, version, header length, then a dictionary padded so that
// the data starts at a multiple of 64 bytes, then the samples, low byte first.
#include "tools/io/file_errors.hpp"

#include <fmt/format.h>

namespace umbra78::tools {
namespace {

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
