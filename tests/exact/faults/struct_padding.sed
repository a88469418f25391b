# fault: struct padding
# in: hw/noise_source.hpp
# by: target m68k g++ -O1: percentage
s/const std::uint64_t pair = (register_.take\(16\));/\
            const auto taken = static_cast<std::uint32_t>(\1);\
            const struct { std::uint8_t tag; std::uint32_t bits; } packed{0, taken};\
            std::uint32_t pair = 0;\
            const auto* bytes_of = reinterpret_cast<const std::uint8_t*>(\&packed);\
            __builtin_memcpy(\&pair, bytes_of + 4, 4);/
