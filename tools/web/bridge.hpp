// The page's way to the machine: one function, JSON in and JSON out. bridge.cpp lists the requests.
#pragma once

#include <memory>
#include <string>
#include <string_view>

namespace umbra78::tools::web {

class Bridge {
public:
    Bridge();
    ~Bridge();
    // Throws SceneError where RenderJob and the instruments do.
    std::string answer(std::string_view request);

    struct Kept;

private:
    std::unique_ptr<Kept> kept_;
};

}  // namespace umbra78::tools::web
