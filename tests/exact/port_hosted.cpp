// Where there is an operating system and a C library: PROGRAM [FILLER [ONLY]].
#include "tests/exact/port.hpp"

#include <cstdio>
#include <cstdlib>

namespace umbra78::exact::port {

void write(const char* text, std::size_t size) {
    std::fwrite(text, 1, size, stdout);
    std::fflush(stdout);
}
std::uint64_t instructions() { return 0; }
void show(const std::uint8_t*, int) {}

}  // namespace umbra78::exact::port

int main(int count, char** arguments) {
    return umbra78_exact(count > 1 ? std::atoi(arguments[1]) : 0, count > 2 ? arguments[2] : "");
}
