// WebAssembly: what runs it supplies write() and show() (run_wasm.mjs, page.html).
#include "tests/exact/port.hpp"

extern "C" {
[[clang::import_module("port"), clang::import_name("write")]]
void port_write(const char*, std::size_t);
[[clang::import_module("port"), clang::import_name("show")]]
void port_show(const std::uint8_t*, int);
[[clang::export_name("draw")]] int draw(int filler) {
    return umbra78_exact(filler, UMBRA78_EXACT_ONLY);
}
}

namespace umbra78::exact::port {

void write(const char* text, std::size_t size) { port_write(text, size); }
std::uint64_t instructions() { return 0; }
void show(const std::uint8_t* plane, int side) { port_show(plane, side); }

}  // namespace umbra78::exact::port
