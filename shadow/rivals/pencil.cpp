#include "shadow/rivals/pencil.hpp"

namespace umbra78::shadow::rivals {
namespace {

struct PencilParts {
    std::span<SeenPlane> planes, eye_edges, light_edges;
    std::span<std::int8_t> eye_sides, light_sides;
};

PencilParts lay_out(Carver& carver, std::size_t facets, std::size_t edges) {
    return {carver.take<SeenPlane>(facets), carver.take<SeenPlane>(edges),
            carver.take<SeenPlane>(edges), carver.take<std::int8_t>(facets),
            carver.take<std::int8_t>(facets)};
}

void fill_edges(const Mesh& mesh, const Centre& centre, const Centre& eye,
                std::span<SeenPlane> out) {
    for (std::size_t e = 0; e < out.size(); ++e) {
        const Edge& edge = mesh.edges[e];
        out[e] = seen(plane_through(centre, mesh.vertices[edge.low], mesh.vertices[edge.high]),
                      eye);
    }
}

}  // namespace

std::size_t setting_bytes(std::size_t facets, std::size_t edges) {
    Carver carver(static_cast<std::byte*>(nullptr));
    lay_out(carver, facets, edges);
    return carver.used();
}

bool make_setting(const Space& space, const Mesh& mesh, const Centre& light,
                  std::span<std::byte> memory, Setting& out) {
    Carver carver(memory);
    const PencilParts p = lay_out(carver, mesh.facets.size(), mesh.edges.size());
    if (!carver.fits()) return false;
    const Centre& eye = space.eye();
    for (std::size_t f = 0; f < mesh.facets.size(); ++f) {
        const Plane plane = mesh.plane(f);
        p.planes[f] = seen(plane, eye);
        p.eye_sides[f] = static_cast<std::int8_t>(sign(p.planes[f].e));
        p.light_sides[f] = static_cast<std::int8_t>(sign(plane.at(light)));
    }
    fill_edges(mesh, eye, eye, p.eye_edges);
    fill_edges(mesh, light, eye, p.light_edges);
    out = {space, mesh, p.planes, {eye, p.eye_edges, p.eye_sides},
           {light, p.light_edges, p.light_sides}};
    return true;
}

bool Setting::hides(const Pencil& from, std::size_t f, std::size_t on, std::int32_t px,
                    std::int32_t py) const {
    const int side = from.sides[f];
    if (side == 0 || f == on) return false;
    for (std::size_t k = 0; k < 3; ++k) {
        const ScreenLine line = meet(planes[on], from.edge(mesh, f, k));
        if (line.sign_at(px, py) != from.inside(mesh, f, k)) return false;
    }
    return meet(planes[on], planes[f]).sign_at(px, py) == -side;
}

Run Setting::hidden_run(const Pencil& from, std::size_t f, std::size_t on, int row) const {
    const int side = from.sides[f];
    if (side == 0 || f == on) return {0, 0};
    Run run = run_of(meet(planes[on], planes[f]), -side, space, row);
    for (std::size_t k = 0; k < 3 && !run.empty(); ++k)
        run = run & run_of(meet(planes[on], from.edge(mesh, f, k)), from.inside(mesh, f, k), space,
                           row);
    return run;
}

Run Setting::covered_run(std::size_t facet, int row) const {
    if (eye.sides[facet] == 0) return {0, 0};
    Run run = whole_row(space);
    for (std::size_t k = 0; k < 3 && !run.empty(); ++k)
        run = run & run_of(line_of(eye.edge(mesh, facet, k)), eye.inside(mesh, facet, k), space,
                           row);
    return run;
}

}  // namespace umbra78::shadow::rivals
