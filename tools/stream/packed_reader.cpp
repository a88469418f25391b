#include "fixed/fnv.hpp"
#include "tools/stream/packed.hpp"

#include <fmt/format.h>

#include <array>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <system_error>
#include <utility>

namespace umbra78::tools {
namespace {

using File = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

constexpr std::int32_t max_place = 32767 << raster::world_fraction;
constexpr std::size_t header_bytes = 20, material_bytes = 12, patch_bytes = 196,
                      triangle_bytes = 56;

// Reads little-endian words off bytes that are there.
class Words {
public:
    explicit Words(const unsigned char* at) : at_(at) {}

    template <class Word>
    Word take() {
        std::uint64_t bits = 0;
        for (std::size_t k = 0; k < sizeof(Word); ++k) bits |= std::uint64_t{at_[k]} << (8 * k);
        at_ += sizeof(Word);
        return static_cast<Word>(bits);
    }

private:
    const unsigned char* at_;
};

std::uint64_t hash_of(std::span<const unsigned char> record) {
    fixed::Fnv1a64 hash;
    for (const unsigned char b : record) hash.byte(b);
    return hash.value();
}

// A unit vector in Q1.14 has this length but for the rounding of its components.
bool is_unit(const std::array<std::int32_t, 3>& n) {
    constexpr std::int64_t one = 1 << 14, slack = 4;
    std::int64_t square = 0;
    for (const std::int64_t c : n) square += c * c;
    return square >= (one - slack) * (one - slack) && square <= (one + slack) * (one + slack);
}

class PackedReader final : public PrimitiveStream {
public:
    PackedReader(File file, std::string name, bool can_rewind)
        : file_(std::move(file)), name_(std::move(name)), can_rewind_(can_rewind) {
        read_header();
    }

    std::span<const raster::Material> materials() const override { return materials_; }
    std::uint64_t count() const override { return count_; }
    bool can_rewind() const override { return can_rewind_; }
    std::string_view name() const override { return name_; }
    const std::string& error() const override { return error_; }
    std::uint64_t hash() const override { return hash_; }

    bool rewind() override {
        if (begun_ && (!can_rewind_ || std::fseek(file_.get(), data_at_, SEEK_SET) != 0))
            return false;
        begun_ = true;
        ended_ = false;
        read_ = sum_ = 0;
        bytes_ = header_size_;
        return true;
    }

    Next next(raster::Surfaces& batch) override {
        if (!error_.empty()) return Next::failed;
        if (ended_) return Next::end;
        std::uint32_t kind = 0, records = 0;
        if (!get(8)) return Next::failed;
        Words words(block_.data());
        kind = words.take<std::uint32_t>();
        records = words.take<std::uint32_t>();
        if (kind == 0) return end(records);
        if (kind > 2 || records == 0 || records > max_packed_records)
            return fail(fmt::format("after {} primitives: a block has kind 1 or 2 and 1 .. {} "
                                    "records, or kind 0; this one has kind {} and {} records",
                                    read_, max_packed_records, kind, records));
        clear();
        if (!(kind == 1 ? get_patches(records) : get_triangles(records))) return Next::failed;
        batch = {patches_, {vertices_, normals_, facets_}};
        return Next::batch;
    }

private:
    Next fail(const std::string& what) {
        if (error_.empty())
            error_ = fmt::format("{}: {}; write it again, with umbra78 pack or as "
                                 "tools/stream/packed.hpp says", name_, what);
        return Next::failed;
    }
    // Of the primitive that is being read, numbered from 0.
    bool fail_at(const std::string& what) {
        fail(fmt::format("primitive {} {}", read_, what));
        return false;
    }

    // The next bytes into the block's memory; false and an error if there are not so many.
    bool get(std::size_t bytes) {
        block_.resize(bytes);
        const std::size_t got = std::fread(block_.data(), 1, bytes, file_.get());
        bytes_ += got;
        if (got == bytes) return true;
        if (std::ferror(file_.get()))
            error_ = fmt::format("cannot read {}: {}; give a packed file, or the pipe of one",
                                 name_, std::generic_category().message(errno));
        else if (bytes_ == 0)
            error_ = fmt::format("{} is empty; give a packed file, or the pipe of one", name_);
        else
            fail(fmt::format("it ends at byte {}, before its end block", bytes_));
        return false;
    }

    void read_header() {
        if (!get(header_bytes)) return;
        if (std::memcmp(block_.data(), "U78PACK1", 8) != 0) {
            error_ = fmt::format("{}: it is not a packed file; make one with umbra78 pack", name_);
            return;
        }
        Words words(block_.data() + 8);
        count_ = words.take<std::uint64_t>();
        const auto materials = words.take<std::uint32_t>();
        if (materials == 0 || materials > UINT16_MAX) {
            fail(fmt::format("it has {} materials, if its numbers are little-endian, and 1 .. "
                             "65535 are possible", materials));
            return;
        }
        if (!get(materials * material_bytes)) return;
        words = Words(block_.data());
        for (std::uint32_t k = 0; k < materials; ++k) materials_.push_back(take_material(words, k));
        header_size_ = bytes_;
        data_at_ = can_rewind_ ? std::ftell(file_.get()) : 0;
    }

    raster::Material take_material(Words& words, std::uint32_t number) {
        const auto level = [&](const char* name, std::int32_t max) {
            const auto v = words.take<std::int32_t>();
            if (v < 0 || v > max)
                fail(fmt::format("{} of material {} is {}, and 0 .. {} are possible", name, number,
                                 v, max));
            return v;
        };
        raster::Material m;
        m.diffuse = level("diffuse", 255);
        m.specular = level("specular", 255);
        m.shininess = level("shininess", 8);
        return m;
    }

    void clear() {
        patches_.clear();
        vertices_.clear();
        normals_.clear();
        facets_.clear();
    }

    // A place less the origin; false and an error if it leaves the limits, or then the words.
    bool take_place(Words& words, raster::World& out) {
        std::array<std::int64_t, 3> v{};
        const std::array<std::int64_t, 3> origin{origin_.x, origin_.y, origin_.z};
        for (std::size_t k = 0; k < 3; ++k) {
            const auto word = words.take<std::int32_t>();
            v[k] = word - origin[k];
            if (word < -largest_ || word > largest_ || v[k] < INT32_MIN || v[k] > INT32_MAX)
                return fail_beyond(word);
        }
        out = {static_cast<std::int32_t>(v[0]), static_cast<std::int32_t>(v[1]),
               static_cast<std::int32_t>(v[2])};
        return true;
    }

    bool fail_beyond(std::int32_t word) {
        const double place = std::ldexp(word, -raster::world_fraction);
        if (word >= -max_place && word <= max_place && largest_ < max_place)
            error_ = fmt::format("{}: primitive {} has the coordinate {:.6g}, beyond "
                                 "stream.largest = {:.6g}; raise it", name_, read_, place,
                                 std::ldexp(largest_, -raster::world_fraction));
        return fail_at(fmt::format("has the coordinate {:.6g}, out of the world, -32767 .. 32767",
                                   place));
    }

    bool take_number(std::uint32_t number, std::uint16_t& out) {
        if (number >= materials_.size())
            return fail_at(fmt::format("names material {}, and there are {}, numbered from 0",
                                       number, materials_.size()));
        out = static_cast<std::uint16_t>(number + first_material_);
        return true;
    }

    void note(std::span<const unsigned char> record) {
        sum_ += hash_of(record);
        ++read_;
    }

    bool get_patches(std::size_t records) {
        if (!get(records * patch_bytes)) return false;
        for (std::size_t k = 0; k < records; ++k) {
            const std::span record = std::span(block_).subspan(k * patch_bytes, patch_bytes);
            Words words(record.data());
            raster::Patch& patch = patches_.emplace_back();
            for (raster::World& p : patch.control)
                if (!take_place(words, p)) return false;
            if (!take_number(words.take<std::uint32_t>(), patch.material)) return false;
            note(record);
        }
        return true;
    }

    bool get_triangles(std::size_t records) {
        if (!get(records * triangle_bytes)) return false;
        for (std::size_t k = 0; k < records; ++k) {
            const std::span record = std::span(block_).subspan(k * triangle_bytes, triangle_bytes);
            Words words(record.data());
            raster::Facet facet;
            for (std::uint32_t& v : facet.vertex) {
                v = static_cast<std::uint32_t>(vertices_.size());
                if (!take_place(words, vertices_.emplace_back())) return false;
            }
            if (!take_normals(words, facet)) return false;
            if (!take_number(words.take<std::uint16_t>(), facet.material)) return false;
            facets_.push_back(facet);
            note(record);
        }
        return true;
    }

    bool take_normals(Words& words, raster::Facet& facet) {
        std::array<std::array<std::int32_t, 3>, 3> normal{};
        bool flat = true, unit = true;
        for (auto& n : normal) {
            for (std::int32_t& c : n) c = words.take<std::int16_t>();
            flat = flat && n == std::array<std::int32_t, 3>{};
            unit = unit && is_unit(n);
        }
        if (flat) return true;
        if (!unit) return fail_at("has a normal that is no unit vector in Q1.14");
        for (std::size_t c = 0; c < 3; ++c) {
            facet.normal[c] = static_cast<std::uint32_t>(normals_.size());
            normals_.push_back(normal[c]);
        }
        return true;
    }

    Next end(std::uint32_t records) {
        if (records != 0) return fail("its end block has records");
        if (count_ != unknown_count && read_ != count_)
            return fail(fmt::format("it holds {} primitives, and says that it holds {}", read_,
                                    count_));
        if (std::fgetc(file_.get()) != EOF) return fail("something follows its end block");
        if (known_ && sum_ != hash_) return fail("it changed between two passes over it");
        ended_ = known_ = true;
        hash_ = sum_;
        return Next::end;
    }

    File file_;
    std::string name_, error_;
    bool can_rewind_, begun_ = false, ended_ = false, known_ = false;
    long data_at_ = 0;
    std::uint64_t bytes_ = 0, header_size_ = 0;  // read of this pass
    std::uint64_t count_ = 0, read_ = 0, sum_ = 0, hash_ = 0;
    std::vector<unsigned char> block_;
    std::vector<raster::Material> materials_;
    std::vector<raster::Patch> patches_;
    std::vector<raster::World> vertices_;
    std::vector<std::array<std::int32_t, 3>> normals_;
    std::vector<raster::Facet> facets_;
};

}  // namespace

OpenedStream open_packed(std::FILE* file, const std::string& name, bool can_rewind) {
    auto stream =
        std::make_unique<PackedReader>(File(file, std::fclose), name, can_rewind);
    if (!stream->error().empty()) return {nullptr, stream->error()};
    return {std::move(stream), ""};
}

}  // namespace umbra78::tools
