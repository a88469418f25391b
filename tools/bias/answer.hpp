// The answer to "which bias?": of a depth map without a scene, or of a scene.
#pragma once

#include "tools/bias/trial.hpp"
#include "tools/bias/units.hpp"
#include "tools/scene/scene_file.hpp"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace umbra78::tools::bias {

// A kind of bias: the least by the bound and by experiment, in world units along the light where
// the surface is steepest (a normal offset: along the normal), and the detachment that the
// experiment's costs: the distance from its caster at which a shadow begins, along the light.
struct Least {
    Kind kind{};
    std::optional<double> bound, found;
    // On the surface that it is for, of a map also on one that faces the light; of a scene as
    // measured.
    std::optional<double> detaches, detaches_facing;
};

struct Answer {
    std::string name;             // the scene's, or what the map is
    double texel = 0, pixel = 0;  // world units
    Amount constant{}, geometry{};  // what is converted: the bound without an experiment's luck
    std::vector<Least> least;
    std::vector<std::string> remarks;
};

Answer answer(const MapSetup&);
// Draws the scene with the machine once for each step of each search. Its truth must be known:
// throws SceneError otherwise, or if it has several lights.
Answer answer(const LoadedScene&);

std::string print(const Answer&);
nlohmann::ordered_json to_json(const Answer&);

}  // namespace umbra78::tools::bias
