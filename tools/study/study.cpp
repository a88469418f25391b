#include "tools/study/study.hpp"

namespace umbra78::tools::study {

std::optional<LoadedScene> Study::scene(const Request& request, const Case& c) const {
    return scene_of(request, c);
}

}  // namespace umbra78::tools::study
