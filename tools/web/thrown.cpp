// What `throw` does in a browser: it hands the exception's message to the page, which leaves this
// instance of the machine and starts another. WebAssembly by clang unwinds no stack, and nothing
// that the page asks for is caught: scenes are read without exceptions, and what is thrown after
// that says that a frame cannot be drawn or that the program is wrong.
#ifdef __wasm__
#include <cstddef>
#include <cstring>
#include <exception>
#include <stdexcept>
#include <typeinfo>

#include "tools/scene/scene_error.hpp"

extern "C" {

// The page's: throws a JavaScript error with this text.
[[noreturn]] void umbra78_thrown(const char* text, std::size_t bytes)
    __attribute__((import_module("page"), import_name("thrown")));

alignas(16) static std::byte exception_room[256];  // one exception, ever, of an instance

void* __cxa_allocate_exception(std::size_t) noexcept { return exception_room; }
void __cxa_free_exception(void*) noexcept {}

[[noreturn]] void __cxa_throw(void* thrown, std::type_info* type, void (*)(void*)) {
    const char* text = type->name();
    if (*type == typeid(umbra78::tools::SceneError) || *type == typeid(std::runtime_error) ||
        *type == typeid(std::logic_error))
        text = static_cast<std::exception*>(thrown)->what();
    umbra78_thrown(text, std::strlen(text));
}

[[noreturn]] void __cxa_rethrow() { umbra78_thrown("rethrown", 8); }
void* __cxa_begin_catch(void* thrown) noexcept { return thrown; }
void __cxa_end_catch() {}
}
#endif
