// Carves aligned pieces off one span of memory. Without memory, or with too little, it adds up what
// would be needed, so that who asks for room is told how much.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace umbra78::shadow {

// The alignment of a frame's memory, in bytes: each buffer starts a line of the host's cache.
inline constexpr std::size_t frame_alignment = 64;

class Carver {
public:
    explicit Carver(std::byte* base) : base_(base), size_(base == nullptr ? 0 : SIZE_MAX) {}
    explicit Carver(std::span<std::byte> memory) : base_(memory.data()), size_(memory.size()) {}

    // Empty if it does not fit.
    template <class T>
    std::span<T> take(std::size_t count) {
        static_assert(alignof(T) <= frame_alignment);
        used_ = (used_ + frame_alignment - 1) / frame_alignment * frame_alignment;
        const std::size_t at = used_;
        used_ += count * sizeof(T);
        if (base_ == nullptr || used_ > size_) return {};
        return {reinterpret_cast<T*>(base_ + at), count};
    }
    // What is left, from an aligned byte on.
    std::span<std::byte> rest() {
        used_ = (used_ + frame_alignment - 1) / frame_alignment * frame_alignment;
        if (base_ == nullptr || used_ >= size_) return {};
        return {base_ + used_, size_ - used_};
    }
    std::size_t used() const { return used_; }
    bool fits() const { return used_ <= size_; }

private:
    std::byte* base_;
    std::size_t size_, used_ = 0;
};

}  // namespace umbra78::shadow
