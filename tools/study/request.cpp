#include "tools/study/request.hpp"

#include "tools/study/paper_scene.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>

namespace umbra78::tools::study {

void take_scene(const std::string& path, Request& request) {
    load_scene(path, {});  // for its errors
    std::ifstream file(path, std::ios::binary);
    take_scene({std::istreambuf_iterator<char>(file), {}}, path, request);
}

void take_scene(const std::string& text, const std::string& path, Request& request) {
    request.scene = parse_scene(text, path, {}, files_beside(path));
    require_one_light(request.scene, "a study");
    request.scene_file = path;
    request.scene_text = text;
    const FileSource files = [&, beside = files_beside(path)](const std::string& named) {
        FileText found = beside(named);
        // Beyond ASCII a model has comments and names only, and JSON takes no bytes that are not
        // UTF-8.
        std::erase_if(found.text, [](char c) { return static_cast<unsigned char>(c) >= 0x80; });
        request.models[named] = found.text;
        return found;
    };
    request.scene = parse_scene(request.scene_text, path, {}, files);
}

LoadedScene scene_of(const Request& request, const Case& c) {
    const FileSource files = [&](const std::string& path) {
        const auto found = request.models.find(path);
        if (found == request.models.end())
            return FileText{path, "", "it is not among the study's inputs; run the study anew"};
        return FileText{path, found->second, ""};
    };
    if (!request.scene_text.empty())
        return parse_scene(request.scene_text, request.scene_file, c.set, files);
    return parse_scene(paper_scene_text, "figures.toml", c.set);
}

}  // namespace umbra78::tools::study
