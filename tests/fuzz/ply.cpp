// Fuzz target: a model's file of the format .ply.
#include "tests/fuzz/model_target.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    return umbra78::tools::test::fuzz_model(bytes, size, "a.ply");
}
