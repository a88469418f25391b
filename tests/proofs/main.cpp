// umbra78_proofs PROGRAM [weakened]: the programs beside the proofs. With `weakened` each has a
// planted fault, which it must find.
#include "tests/proofs/search.hpp"

#include <cstdio>
#include <cstring>

namespace umbra78::proofs {

bool planted = false;

bool errors() {
    transform_errors();
    filter_errors();
    line_errors();
    return surface_errors();
}

}  // namespace umbra78::proofs

int main(int count, char** words) {
    using namespace umbra78::proofs;
    struct Program {
        const char* name;
        bool (*run)();
    };
    constexpr Program programs[] = {
        {"agree", agree}, {"exhaustive", exhaustive}, {"forms", forms}, {"errors", errors}};
    planted = count > 2 && std::strcmp(words[2], "weakened") == 0;
    for (const Program& p : programs)
        if (count > 1 && std::strcmp(words[1], p.name) == 0) return p.run() ? 0 : 1;
    std::printf("umbra78_proofs: agree, exhaustive, forms or errors; see tests/proofs/run -h\n");
    return 2;
}
