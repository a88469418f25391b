// The robot of figure 8, as a table of parts.
//
// The robot of the paper ("composed of over 350 bicubic surface patches") is lost. This one is our
// own, a machine of its time: egg head, barrel chest, ball joints. It stands on y = 0, looks along
// z, and is 6.8 high; its right arm is at the left of who faces it. To change it, change the
// table and print the files in tools/scenes/models again.
#include "tools/sculpt/model.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace umbra78::tools {
namespace {

const Chain head_profile = Pen(0, 4.76).line(0.5, 4.78).bend(0.78, 4.78, 0.8, 5.1)
                               .bend(0.86, 6.08, 0, 6.1);
const Chain chest_profile = Pen(0, 2.92).line(0.5, 2.92).bend(0.66, 2.92, 0.82, 3.25)
                                .bend(1.1, 3.8, 1.04, 4.1).bend(0.956, 4.52, 0.5, 4.54)
                                .line(0, 4.56);
const Chain foot_profile = Pen(0, 0).line(0.92, 0).bend(1.01, 0, 1, 0.18)
                               .bend(0.98, 0.56, 0, 0.58);
const Chain pelvis_profile = Pen(0, 1.98).bend(0.66, 1.98, 0.66, 2.3, 0.6)
                                 .bend(0.66, 2.62, 0, 2.62, 0.7);
// A short tube around an eye, in front of the head.
const Chain goggle_profile = Pen(0.24, -0.2).line(0.24, 0.12).bend(0.24, 0.17, 0.2, 0.17)
                                 .bend(0.165, 0.17, 0.165, 0.12).line(0.15, -0.04);
const Chain mouth_line = through({{-0.34, 5.05, 0.73}, {-0.19, 4.96, 0.79}, {0, 4.93, 0.82},
                                  {0.19, 4.96, 0.79}, {0.34, 5.05, 0.73}});
const Chain antenna_line = through({{0, 6.05, 0}, {0.03, 6.3, 0}, {0.12, 6.55, -0.02}});

// Where an arm's joints are, the direction of its open hand and the side to which it spreads.
struct Arm {
    std::string side;
    Point shoulder, elbow, wrist, hand, spread;
};
const Arm right_arm{"right", {-1.34, 4.1, 0.05}, {-1.75, 3.25, 0.75}, {-0.85, 3.75, 1.7},
                    {0.55, 0.75, 0.35}, {-0.6, 0.6, 0.1}};
const Arm left_arm{"left", {1.34, 4.1, 0.05}, {2.0, 3.72, 0.3}, {2.05, 4.85, 0.55},
                   {0.25, 1, 0.1}, {1, -0.2, 0.2}};

Surface ball(Point centre, double radius) {
    return placed(ellipsoid(radius, radius, radius), {centre});
}

Surface both(const Surface& one) { return joined({one, mirrored(one)}); }

// A hose of so many rings from one point to another.
Surface bellows(Point from, Point to, double radius, int rings) {
    const double step = length(to - from) / rings, deep = 0.8 * radius;
    Pen pen(deep, 0);
    for (int k = 0; k < rings; ++k) {
        const double y = k * step;
        pen.bend(radius, y, radius, y + step / 2).bend(radius, y + step, deep, y + step);
    }
    return along(lathe(pen, circle(4)), from, to);
}

// Three fingers of two links, which fan out from the palm.
Surface fingers(const Arm& arm) {
    const Point ahead = unit(arm.hand);
    const Point aside = unit(arm.spread - dot(arm.spread, ahead) * ahead);
    const Point palm = arm.wrist + 0.38 * ahead;
    Surface all;
    for (const double fan : {-55., 0., 55.}) {
        const double c = std::cos(radians(fan)), s = std::sin(radians(fan));
        const Point out = c * ahead + s * aside;
        const Point bent = unit(out + 0.6 * ahead);
        const Point knuckle = palm + 0.2 * out, joint = knuckle + 0.24 * out;
        all = joined({all, limb(knuckle, joint, 0.11, 0.1),
                      limb(joint, joint + 0.26 * bent, 0.115, 0.085)});
    }
    return all;
}

std::vector<Part> arm_parts(const Arm& arm) {
    const auto named = [&](const char* what) { return arm.side + " " + what; };
    const Point ahead = unit(arm.hand), palm = arm.wrist + 0.38 * ahead;
    const Surface cuff = along(lathe(Pen(0.17, -0.3).line(0.27, 0.04).bend(0.27, 0.12, 0.2, 0.12)
                                         .line(0.1, 0.06), circle(4)), arm.wrist, palm);
    return {{"body", named("shoulder"), ball(arm.shoulder, 0.38)},
            {"details", named("upper arm"), bellows(arm.shoulder, arm.elbow, 0.22, 6)},
            {"body", named("elbow"), ball(arm.elbow, 0.27)},
            {"body", named("forearm"), limb(arm.elbow, arm.wrist, 0.17, 0.21)},
            {"details", named("cuff"), cuff},
            {"body", named("palm"), along(ellipsoid(0.24, 0.27, 0.24), palm, palm + ahead)},
            {"details", named("fingers"), fingers(arm)}};
}

// On the panel of the chest, which is at the origin and looks along z.
Surface knob(double x, double y, double radius, double height) {
    return along(button(radius, height, 0.3 * radius), {x, y, 0.1}, {x, y, 1});
}

std::vector<Part> leg_parts() {
    const Chain soft = rounded_square(0.66);
    return {
        {"body", "feet", both(placed(lathe(foot_profile, soft),
                                     {{0.62, 0, 0.24}, {0, 8, 0}, {0.52, 1, 0.86}}))},
        {"details", "ankles", both(ball({0.58, 0.62, 0}, 0.24))},
        {"body", "shins", both(limb({0.58, 0.66, 0}, {0.56, 1.25, 0}, 0.27, 0.2))},
        {"details", "knees", both(ball({0.56, 1.4, 0.03}, 0.27))},
        {"body", "thighs", both(limb({0.56, 1.5, 0}, {0.5, 2.15, 0}, 0.2, 0.27))},
        {"body", "pelvis", placed(lathe(pelvis_profile, soft), {{}, {}, {1.12, 1, 0.9}})},
    };
}

std::vector<Part> trunk_parts() {
    const Placement on_chest{{0, 3.86, 0.83}, {-6, 0, 0}};
    const Surface knobs = joined({knob(-0.24, 0.13, 0.13, 0.12), knob(0.24, 0.13, 0.13, 0.12),
                                  knob(-0.28, -0.16, 0.07, 0.1), knob(0, -0.16, 0.07, 0.1),
                                  knob(0.28, -0.16, 0.07, 0.1)});
    return {
        {"details", "waist", bellows({0, 2.5, 0}, {0, 3.0, 0}, 0.5, 3)},
        {"body", "chest", placed(lathe(chest_profile, circle(8)), {{}, {}, {1, 1, 0.84}})},
        {"details", "belt", placed(ring(0.82, 0.07, 8), {{0, 3.2, 0}, {}, {1, 1, 0.84}})},
        {"details", "panel", placed(rounded_box(0.52, 0.38, 0.12), on_chest)},
        {"body", "knobs", placed(knobs, on_chest)},
    };
}

std::vector<Part> head_parts() {
    const Point eye{0.31, 5.42, 0.66}, look{0.18, 0.02, 1}, side{1, 0, 0}, ear{0.74, 5.3, 0};
    const Surface ear_cap = joined({along(button(0.24, 0.14, 0.06), ear, ear + side),
                                    along(button(0.1, 0.32, 0.05), ear, ear + side)});
    return {
        {"details", "neck", bellows({0, 4.5, 0}, {0, 4.84, 0}, 0.42, 2)},
        {"body", "head", lathe(head_profile, circle(8))},
        {"details", "brow", placed(ring(0.795, 0.05, 8), {{0, 5.72, 0}, {}, {0.86, 1, 0.86}})},
        {"details", "ears", both(ear_cap)},
        {"details", "goggles", both(along(lathe(goggle_profile, circle(8)), eye, eye + look))},
        {"body", "eyes", both(along(ellipsoid(0.16, 0.1, 0.16, 8), eye, eye + look))},
        {"details", "mouth", tube(mouth_line, {0.03, 0.045, 0.05, 0.045, 0.03})},
        {"details", "antenna", joined({placed(button(0.16, 0.1, 0.05), {{0, 6.05, 0}}),
                                       tube(antenna_line, {0.05, 0.04, 0.035})})},
        {"body", "antenna's ball", ball({0.14, 6.64, -0.02}, 0.14)},
    };
}

}  // namespace

std::vector<Part> robot_parts() {
    std::vector<Part> parts;
    for (std::vector<Part> more : {leg_parts(), trunk_parts(), head_parts(),
                                   arm_parts(right_arm), arm_parts(left_arm)})
        std::ranges::move(more, std::back_inserter(parts));
    return parts;
}

}  // namespace umbra78::tools
