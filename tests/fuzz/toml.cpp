// Fuzz target: a TOML text, whose arrays of numbers may stay text or pass through toml++. Both ways
// give the same tree, or the same error.
#include "tests/fuzz/model_target.hpp"
#include "tests/tools/scene/toml_trees.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    using namespace umbra78::tools::test;
    require(same_both_ways({reinterpret_cast<const char*>(bytes), size}));
    return 0;
}
