// The four functions that a compiler calls of itself, where there is no C library; and strlen,
// which a string_view of a name calls where the compiler does not count the letters (g++ -Os).
#include <cstddef>
#include <cstdint>

extern "C" {

void* memcpy(void* to, const void* from, std::size_t size) {
    auto* t = static_cast<unsigned char*>(to);
    const auto* f = static_cast<const unsigned char*>(from);
    for (; size > 0; --size) *t++ = *f++;
    return to;
}
void* memmove(void* to, const void* from, std::size_t size) {
    auto* t = static_cast<unsigned char*>(to);
    const auto* f = static_cast<const unsigned char*>(from);
    if (reinterpret_cast<std::uintptr_t>(t) <= reinterpret_cast<std::uintptr_t>(f))
        return memcpy(to, from, size);
    for (; size > 0; --size) t[size - 1] = f[size - 1];
    return to;
}
void* memset(void* to, int value, std::size_t size) {
    auto* t = static_cast<unsigned char*>(to);
    for (; size > 0; --size) *t++ = static_cast<unsigned char>(value);
    return to;
}
int memcmp(const void* a, const void* b, std::size_t size) {
    const auto* p = static_cast<const unsigned char*>(a);
    const auto* q = static_cast<const unsigned char*>(b);
    for (; size > 0; --size, ++p, ++q)
        if (*p != *q) return *p < *q ? -1 : 1;
    return 0;
}
std::size_t strlen(const char* text) {
    std::size_t n = 0;
    while (text[n] != 0) ++n;
    return n;
}
}
