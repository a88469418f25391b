// PNG by stb_image_write and stb_image.
#include "tools/io/file_errors.hpp"

#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#define STBI_WRITE_NO_STDIO
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#include <stb/stb_image_write.h>
#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_PNG
#include <stb/stb_image.h>
#pragma GCC diagnostic pop

#include <memory>

namespace umbra78::tools {
namespace {

constexpr std::size_t max_bytes = 1 << 30;  // stb counts in int

// stb's least level and the Sub filter in every row: 3 to 4 ms for a figure of 512 x 512, two
// thirds of the time of stb's defaults, for about as many bytes.
std::vector<std::byte> png(const Path& path, int width, int height, int channels,
                           std::span<const std::uint8_t> samples) {
    expect_samples(path, width, height, samples.size(), static_cast<std::size_t>(channels));
    static const bool prepared = [] {
        stbi_write_png_compression_level = 5;
        stbi_write_force_png_filter = 1;
        return true;
    }();
    std::vector<std::byte> bytes;
    const auto append_to = [](void* context, void* data, int length) {
        const auto* from = static_cast<const std::byte*>(data);
        auto& to = *static_cast<std::vector<std::byte>*>(context);
        to.insert(to.end(), from, from + length);
    };
    if (!prepared || samples.size() > max_bytes ||
        !stbi_write_png_to_func(append_to, &bytes, width, height, channels, samples.data(),
                                width * channels))
        fail_to_write(path, "the PNG compressor gave up", "write a smaller picture");
    return bytes;
}

}  // namespace

void write_png_gray(const Path& path, int width, int height,
                    std::span<const std::uint8_t> samples, FileSet* set) {
    write_file(path, png(path, width, height, 1, samples), set);
}

void write_png_rgb(const Path& path, int width, int height,
                   std::span<const std::uint8_t> samples, FileSet* set) {
    write_file(path, png(path, width, height, 3, samples), set);
}

std::vector<std::byte> png_gray(int width, int height, std::span<const std::uint8_t> samples) {
    return png("a picture", width, height, 1, samples);
}

std::optional<GrayPng> read_png_gray(const Path& path) {
    int width = 0, height = 0, channels = 0;
    if (!stbi_info(path.c_str(), &width, &height, &channels) || channels != 1) return {};
    const std::unique_ptr<stbi_uc, void (*)(void*)> samples(
        stbi_load(path.c_str(), &width, &height, &channels, 1), stbi_image_free);
    if (!samples) return {};
    const auto n = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    return GrayPng{width, height, {samples.get(), samples.get() + n}};
}

}  // namespace umbra78::tools
