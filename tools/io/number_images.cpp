#include "tools/io/number_images.hpp"

#include "tools/io/file_errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>

namespace umbra78::tools {
namespace {

constexpr std::string_view numbers_remedy =
    "give a binary PGM, an NPY, a one-channel PFM, or raw numbers and --size";
constexpr int longest_side = 4096;

constexpr std::array<std::string_view, 5> kind_names{"u8", "u16", "u32", "f32", "f64"};
constexpr std::array<std::size_t, 5> kind_bytes{1, 2, 4, 4, 8};

std::size_t bytes_of(NumberKind kind) { return kind_bytes[static_cast<std::size_t>(kind)]; }

// A number from its bytes, as bits and then as what they mean.
double number_from(const char* bytes, NumberKind kind, bool high_first) {
    const std::size_t size = bytes_of(kind);
    std::uint64_t bits = 0;
    for (std::size_t k = 0; k < size; ++k) {
        const std::size_t at = high_first ? k : size - 1 - k;
        bits = bits << 8 | static_cast<unsigned char>(bytes[at]);
    }
    if (kind == NumberKind::f32)
        return static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(bits)));
    if (kind == NumberKind::f64) return std::bit_cast<double>(bits);
    return static_cast<double>(bits);
}

// Fills an image whose sizes and kind are known with the numbers behind the head.
void take_numbers(const Path& path, std::string_view bytes, bool high_first, NumberImage& image) {
    if (image.width < 1 || image.height < 1 || image.width > longest_side ||
        image.height > longest_side)
        fail_to_read(path, fmt::format("{} x {} numbers", image.width, image.height),
                     fmt::format("give at most {0} x {0} of them, for a frame has no more",
                                 longest_side));
    const std::size_t size = bytes_of(image.kind), wanted = image.pixels() * size;
    if (bytes.size() != wanted)
        fail_to_read(path,
                     fmt::format("{} bytes of numbers where {} x {} of {} need {}", bytes.size(),
                                 image.width, image.height, name_of(image.kind), wanted),
                     "give the whole file, or its right size and kind");
    if (image.max == 0 && !is_real(image.kind))
        image.max = static_cast<std::uint32_t>((std::uint64_t{1} << 8 * size) - 1);
    image.values.resize(image.pixels());
    for (std::size_t at = 0; at < image.values.size(); ++at)
        image.values[at] = number_from(bytes.data() + at * size, image.kind, high_first);
}

// --- PFM: "Pf", width, height, scale (negative: low byte first), then floats, rows from below

struct HeadReader {
    const Path& path;
    std::string_view bytes;
    std::size_t at = 2;

    std::string_view word(const char* what) {
        const std::size_t first = bytes.find_first_not_of(" \t\r\n", at);
        const std::size_t end =
            first == std::string_view::npos ? first : bytes.find_first_of(" \t\r\n", first);
        if (end == std::string_view::npos)
            fail_to_read(path, fmt::format("its head ends before its {}", what), numbers_remedy);
        at = end;
        return bytes.substr(first, end - first);
    }
    template <class Number>
    Number number(const char* what) {
        const std::string_view text = word(what);
        Number value{};
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
        if (error != std::errc() || end != text.data() + text.size())
            fail_to_read(path, fmt::format("its {} '{}' is no number", what, text),
                         numbers_remedy);
        return value;
    }
};

NumberImage read_pfm(const Path& path, std::string_view bytes) {
    HeadReader head{path, bytes};
    NumberImage image;
    image.width = head.number<int>("width");
    image.height = head.number<int>("height");
    const double scale = head.number<double>("scale");
    take_numbers(path, bytes.substr(head.at + 1), scale > 0, image);
    const auto row = static_cast<std::size_t>(image.width);
    for (int y = 0; y < image.height / 2; ++y) {
        const auto up = image.values.begin() + static_cast<std::ptrdiff_t>(row) * y;
        const auto down =
            image.values.begin() + static_cast<std::ptrdiff_t>(row) * (image.height - 1 - y);
        std::swap_ranges(up, up + static_cast<std::ptrdiff_t>(row), down);
    }
    return image;
}

NumberImage read_pgm_numbers(const Path& path) {
    const Pgm picture = read_pgm(path);
    NumberImage image;
    image.width = picture.width;
    image.height = picture.height;
    if (picture.width > longest_side || picture.height > longest_side)
        take_numbers(path, {}, false, image);  // says that it is too large
    image.kind = picture.maxval > 255 ? NumberKind::u16 : NumberKind::u8;
    image.max = static_cast<std::uint32_t>(picture.maxval);
    image.values.assign(picture.samples.begin(), picture.samples.end());
    return image;
}

// --- NPY: the head is the text of a Python dictionary

constexpr std::string_view npy_magic = "\x93NUMPY";

// What stands behind a key of the head, up to a character.
std::string_view value_in(const Path& path, std::string_view head, std::string_view key,
                          std::string_view first, char last) {
    const std::size_t named = head.find(key);
    const std::size_t from =
        named == std::string_view::npos ? named : head.find(first, named + key.size());
    const std::size_t end =
        from == std::string_view::npos ? from : head.find(last, from + first.size());
    if (end == std::string_view::npos)
        fail_to_read(path, fmt::format("its head has no {}", key), numbers_remedy);
    return head.substr(from + first.size(), end - from - first.size());
}

NumberKind kind_of_dtype(const Path& path, std::string_view dtype) {
    constexpr std::array<std::string_view, 5> known{"u1", "u2", "u4", "f4", "f8"};
    for (std::size_t k = 0; k < known.size(); ++k)
        if (dtype.size() == 3 && dtype.substr(1) == known[k]) return static_cast<NumberKind>(k);
    fail_to_read(path, fmt::format("its numbers are of the kind '{}'", dtype),
                 "give them as uint8, uint16, uint32, float32 or float64, as numpy's astype does");
}

// The sides that are not 1, the last two of them.
void take_shape(const Path& path, std::string_view shape, NumberImage& image) {
    std::vector<int> sides;
    for (const char* at = shape.data(); at < shape.data() + shape.size();) {
        int side = 0;
        const auto [end, error] = std::from_chars(at, shape.data() + shape.size(), side);
        if (error == std::errc() && side != 1) sides.push_back(side);
        at = error == std::errc() ? end : at + 1;
    }
    if (sides.size() > 2)
        fail_to_read(path, fmt::format("its shape is ({})", shape),
                     "give an array of two dimensions, height and width");
    image.width = sides.empty() ? 1 : sides.back();
    image.height = sides.size() < 2 ? 1 : sides.front();
}

NumberImage read_npy(const Path& path, std::string_view bytes) {
    const bool long_head = bytes.size() > 6 && bytes[6] > 1;
    const std::size_t start = long_head ? 12 : 10;
    std::size_t length = 0;
    for (std::size_t k = start; k-- > 8;)
        length = length << 8 | (k < bytes.size() ? static_cast<unsigned char>(bytes[k]) : 0xFFu);
    if (bytes.size() < start || length > bytes.size() - start)
        fail_to_read(path, "it ends within its head", numbers_remedy);
    const std::string_view head = bytes.substr(start, length);
    const std::string_view dtype = value_in(path, head, "'descr'", "'", '\'');
    const std::string_view order = value_in(path, head, "'fortran_order'", ":", ',');
    NumberImage image;
    image.kind = kind_of_dtype(path, dtype);
    take_shape(path, value_in(path, head, "'shape'", "(", ')'), image);
    const bool by_columns = order.find("True") != std::string_view::npos;
    if (by_columns) std::swap(image.width, image.height);
    take_numbers(path, bytes.substr(start + length), dtype.front() == '>', image);
    if (by_columns) {
        NumberImage turned = image;
        std::swap(turned.width, turned.height);
        std::size_t at = 0;
        for (int y = 0; y < turned.height; ++y)
            for (int x = 0; x < turned.width; ++x) turned.values[at++] = image.at(y, x);
        return turned;
    }
    return image;
}

}  // namespace

std::string_view name_of(NumberKind kind) { return kind_names[static_cast<std::size_t>(kind)]; }

NumberImage read_numbers(const Path& path, const std::optional<RawNumbers>& raw) {
    const std::string bytes = read_bytes(path, numbers_remedy);
    const std::string ending = path.extension().string();
    const bool has_head = ending == ".pgm" || ending == ".npy" || ending == ".pfm";
    NumberImage image;
    if (raw && !has_head) {  // whatever it begins with
        image.width = raw->width;
        image.height = raw->height;
        image.kind = raw->kind;
        take_numbers(path, bytes, false, image);
    } else if (bytes.starts_with("P5")) {
        image = read_pgm_numbers(path);
    } else if (bytes.starts_with(npy_magic)) {
        image = read_npy(path, bytes);
    } else if (bytes.starts_with("Pf")) {
        image = read_pfm(path, bytes);
    } else if (bytes.starts_with("PF")) {
        fail_to_read(path, "it is a PFM of three channels", "give one of a single channel (Pf)");
    } else {
        fail_to_read(path, "it is no PGM, NPY or PFM",
                     "give --size WIDTHxHEIGHT if it holds raw numbers");
    }
    image.name = path.string();
    return image;
}

}  // namespace umbra78::tools
