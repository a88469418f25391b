// The rivals' scenes with right answers: each shows one thing that an algorithm may get wrong.
//
// 32 x 32 pixels of 16 words; the frame reaches from -256 to 256, and a pixel's centre is an odd
// multiple of 8. Light and eye are integers, so shadows can be counted by hand.
#pragma once

#include "tests/shadow/rivals/scenes.hpp"

#include <vector>

namespace umbra78::shadow::rivals::test {

inline Polygons named(const char* name, Centre light, Centre eye = straight_ahead) {
    Polygons p;
    p.name = name;
    p.xy_bits = 5;
    p.fraction = 4;
    p.eye = eye;
    p.light = light;
    return p;
}

// The whole frame, at one depth.
inline Polygons& with_wall(Polygons& p, int z) {
    return p.quad({-400, -400, z}, {400, -400, z}, {400, 400, z}, {-400, 400, z});
}
// A rectangle facing the eye.
inline Polygons& with_sheet(Polygons& p, int x0, int y0, int x1, int y1, int z) {
    return p.quad({x0, y0, z}, {x1, y0, z}, {x1, y1, z}, {x0, y1, z});
}

// A light from the left and before: what is d before the wall casts its shadow d to the right.
inline constexpr Centre from_left{-64, 0, -64, 0};

inline std::vector<Polygons> named_scenes() {
    std::vector<Polygons> all;
    const auto add = [&](Polygons p) { all.push_back(std::move(p)); };

    Polygons p = named("one_triangle", from_left);
    add(with_wall(p, 160).triangle({-160, -96, 0}, {-64, -96, 0}, {-160, 96, 0}));
    p = named("both_windings", from_left);
    add(with_wall(p, 160).triangle({-160, 96, 0}, {-64, -96, 0}, {-160, -96, 0}));

    p = named("shared_edge", from_left);
    add(with_sheet(with_wall(p, 160), -160, -96, -64, 96, 0));
    p = named("split_in_four", from_left);
    with_wall(p, 160);
    const Point middle{-112, 0, 0};
    p.triangle({-160, -96, 0}, {-64, -96, 0}, middle).triangle({-64, -96, 0}, {-64, 96, 0}, middle);
    add(p.triangle({-64, 96, 0}, {-160, 96, 0}, middle).triangle({-160, 96, 0}, {-160, -96, 0},
                                                                  middle));

    // Edges of the shadow pass through pixels' centres: 16 x 16 pixels are dark, no more or fewer.
    p = named("edge_on_centres", from_left);
    add(with_sheet(with_wall(p, 256), -376, -120, -120, 136, 0));

    // The box stands on the wall: its far face lies in the wall's plane.
    p = named("cube_on_floor", from_left);
    add(with_wall(p, 96).box({-160, -64, 0}, {-64, 64, 96}));

    // Each of three bars lies over the next and under the one before.
    p = named("cycle_of_three", {-64, -32, -128, 0});
    with_wall(p, 200);
    p.quad({-200, -120, 0}, {120, -120, 60}, {120, -80, 60}, {-200, -80, 0});
    p.quad({80, -160, 0}, {120, -160, 0}, {0, 160, 60}, {-40, 160, 60});
    add(p.quad({40, 160, 0}, {80, 160, 0}, {-120, -160, 60}, {-160, -160, 60}));

    p = named("through_each_other", from_left);
    with_wall(p, 160);
    p.quad({-200, -96, -40}, {-72, -96, 40}, {-72, 96, 40}, {-200, 96, -40});
    add(p.quad({-200, -48, 40}, {-72, -48, -40}, {-72, 48, -40}, {-200, 48, 40}));

    // Contour edges cross in the light's view.
    p = named("crossed_bars", from_left);
    with_wall(p, 160);
    add(with_sheet(with_sheet(p, -200, -24, -40, 24, 0), -144, -120, -96, 120, 40));

    // Three facets at one edge.
    p = named("book", from_left);
    with_wall(p, 160);
    const Point spine_top{-112, -96, 0}, spine_foot{-112, 96, 0};
    p.triangle(spine_top, spine_foot, {-200, 0, 20});
    p.triangle(spine_top, spine_foot, {-24, 0, 20});
    add(p.triangle(spine_top, spine_foot, {-112, 0, 120}));

    // A window in a sheet: the light comes through it, and through it onto another sheet.
    p = named("frame_in_frame", from_left);
    with_wall(p, 160);
    with_sheet(p, -224, -128, -48, -64, 0);
    with_sheet(p, -224, 64, -48, 128, 0);
    with_sheet(p, -224, -64, -176, 64, 0);
    with_sheet(p, -96, -64, -48, 64, 0);
    add(with_sheet(p, -64, -24, -32, 24, 80));

    // A facet that the light sees edge-on casts nothing and leaves no gap beside its neighbour.
    p = named("edge_on_facet", from_left);
    with_wall(p, 160);
    p.quad({-160, -96, 0}, {-64, -96, 96}, {-64, 96, 96}, {-160, 96, 0});
    add(with_sheet(p, -160, -96, -80, 96, 0));

    // The eye stands in the shadow of a sheet beside it.
    p = named("eye_in_shadow", from_left, {0, 0, -512, 1});
    with_wall(p, 160);
    p.quad({-128, -400, -640}, {-96, -400, -600}, {-96, 400, -600}, {-128, 400, -640});
    add(with_sheet(p, -64, -64, 0, 64, 0));
    // The eye lies exactly in the plane of a volume's side, and sees what is dark on either hand.
    p = named("eye_on_side", {0, -64, 0, 0}, {0, 0, -512, 1});
    p.quad({-400, 128, -300}, {400, 128, -300}, {400, 128, 600}, {-400, 128, 600});
    add(p.quad({0, -96, -600}, {300, -96, -600}, {300, -96, 300}, {0, -96, 300}));

    // Behind the scene, toward the eye: all that is seen is turned from it.
    p = named("light_behind_scene", {16, 8, 64, 0});
    add(with_sheet(with_wall(p, 160), -64, -64, 64, 64, 0));
    // Behind the eye's back, through a sheet that the eye does not see.
    p = named("light_behind_eye", {0, 0, -1024, 1}, {0, 0, -512, 1});
    with_sheet(with_wall(p, 160), -24, -40, 40, 56, -700);
    add(with_sheet(p, 80, 80, 144, 144, 0));
    p = named("light_is_eye", {0, 0, -512, 1}, {0, 0, -512, 1});
    add(with_sheet(with_sheet(with_wall(p, 160), -64, -64, 64, 64, 0), -100, 0, 20, 90, 60));

    // 256 sheets before one another: a counter of 8 bits would come to 0 and be lit.
    p = named("nested_256", from_left);
    with_wall(p, 300);
    for (int n = 0; n < 256; ++n) with_sheet(p, -200 + n / 2, -64, -100 + n / 2, 64, n / 2);
    add(p);

    p = named("vertex_on_edge", from_left);
    with_wall(p, 160);
    p.triangle({-160, -96, 0}, {-64, -96, 0}, {-160, 96, 0});
    add(p.triangle({-160, 0, 0}, {-240, -64, 0}, {-240, 64, 0}));

    // One plane alone, steep to the light: nothing on it is dark.
    p = named("slanted_plane", {64, 8, 38, 0});
    add(p.quad({-400, -400, -200}, {400, -400, 300}, {400, 400, 310}, {-400, 400, -190}));

    // A wall thinner than a pixel keeps the light out.
    p = named("thin_wall", {-64, 0, -16, 0});
    add(with_wall(p, 160).box({-101, -128, 0}, {-100, 128, 160}));

    p = named("three_layers", from_left);
    add(with_sheet(with_sheet(with_wall(p, 160), -200, -96, -104, 0, 0), -160, -48, -64, 48, 48));

    // A lamp in a box that is open toward the eye, with a block before it.
    p = named("lamp_in_box", {40, -24, 100, 1}, {0, 0, -512, 1});
    const Point a{-240, -240, 0}, b{240, -240, 0}, c{240, 240, 0}, d{-240, 240, 0};
    const Point e{-240, -240, 240}, f{240, -240, 240}, g{240, 240, 240}, h{-240, 240, 240};
    p.quad(a, b, f, e).quad(b, c, g, f).quad(c, d, h, g).quad(d, a, e, h).quad(e, f, g, h);
    add(p.box({-120, -40, 120}, {-20, 120, 220}));
    return all;
}

// The facets in another order, and each begun at another of its corners.
inline Polygons in_another_order(Polygons p, std::uint32_t seed) {
    std::mt19937 random(seed);
    for (std::size_t n = p.facets.size(); n > 1; --n)
        std::swap(p.facets[n - 1], p.facets[random() % n]);
    for (Triangle& t : p.facets)
        std::rotate(t.vertex.begin(), t.vertex.begin() + random() % 3, t.vertex.end());
    return p;
}

}  // namespace umbra78::shadow::rivals::test
