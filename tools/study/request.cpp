#include "tools/study/request.hpp"

#include "tools/study/paper_scene.hpp"

namespace umbra78::tools::study {

LoadedScene scene_of(const Request& request, const Case& c) {
    if (!request.scene_text.empty())
        return parse_scene(request.scene_text, request.scene_file, c.set);
    return parse_scene(paper_scene_text, "figures.toml", c.set);
}

}  // namespace umbra78::tools::study
