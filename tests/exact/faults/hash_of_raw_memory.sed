# fault: hash of raw memory
# in: fixed/fnv.hpp
# by: target s390x g++ -O1: figures
s/byte\(static_cast<std::uint8_t>\(word >> 8\)\);\n[^;]*;/\
        const std::uint16_t kept = __builtin_bswap16(word);\
        std::uint8_t raw[2] = {};\
        __builtin_memcpy(raw, \&kept, 2);\
        byte(raw[0]);\
        byte(raw[1]);/
