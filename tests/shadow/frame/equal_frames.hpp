// expect_equal_frames compares every buffer of two frames word by word and reports the first
// difference of each; equal_frames returns only whether they are equal.
#pragma once

#include "shadow/frame/frame.hpp"
#include "tests/support/buffers.hpp"

#include <algorithm>

namespace umbra78::shadow::test {

// visit(name, a's plane, b's plane) for each of the eight; a form without a map has seven, frames
// that both keep normals have nine.
template <class A, class B, class Visit>
void for_planes(const FrameBuffers<A>& a, const FrameBuffers<B>& b, Visit&& visit) {
    if (!a.lights[0].map.depth.empty() && !b.lights[0].map.depth.empty())
        visit("light_z", a.lights[0].map.depth, b.lights[0].map.depth);
    visit("observer_z", a.observer.depth, b.observer.depth);
    visit("intensity", a.observer.intensity, b.observer.intensity);
    visit("direct", a.observer.direct, b.observer.direct);
    if (!a.observer.normal.empty() && !b.observer.normal.empty())
        visit("normal", a.observer.normal, b.observer.normal);
    visit("mask", a.lights[0].mask, b.lights[0].mask);
    visit("edges", a.lights[0].edges, b.lights[0].edges);
    visit("filtered", a.lights[0].filtered, b.lights[0].filtered);
    visit("picture", a.picture, b.picture);
}

template <class A, class B>
void expect_equal_frames(
    const FrameBuffers<A>& a, const FrameBuffers<B>& b,
    umbra78::test::Constant of_constant = umbra78::test::Constant::fails) {
    for_planes(a, b, [&](const char* name, const auto& p, const auto& q) {
        umbra78::test::expect_equal_buffers(name, a.observer.size_px(), p, q, of_constant);
    });
}

template <class A, class B>
bool equal_frames(const FrameBuffers<A>& a, const FrameBuffers<B>& b) {
    bool equal = true;
    for_planes(a, b, [&](const char*, const auto& p, const auto& q) {
        equal &= std::equal(p.begin(), p.end(), q.begin(), q.end());
    });
    return equal;
}

}  // namespace umbra78::shadow::test
