// Fuzz target: a scene's text. The models that it may name are a triangle and a text that is none;
// the stream is of 9 patches.
#include "tests/fuzz/model_target.hpp"
#include "tools/scene/scene.hpp"
#include "tools/stream/hills.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    using namespace umbra78::tools;
    const auto files = [](const std::string& path) -> FileText {
        if (path == "a.obj") return {.name = path, .text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"};
        if (path == "b.bpt") return {.name = path, .text = "1\n3 3\n"};
        return {.name = path, .error = "there is no such file"};
    };
    const std::string_view text{reinterpret_cast<const char*>(bytes), size};
    const auto streams = [](const std::string&) {
        return OpenedStream{std::make_unique<Hills>(HillsShape{.patches = 9}), ""};
    };
    const SceneResult result = read_scene(text, "a.toml", {}, files, streams);
    test::require(result.ok() || result.error.find('\n') == std::string::npos);
    return 0;
}
