#include "shadow/rivals/light_lines.hpp"

namespace umbra78::shadow::rivals {
namespace {

struct LightLinePieces {
    std::span<LightLine> edges;
    std::span<Meeting> meetings;
};

LightLinePieces lay_out(Carver& carver, const Mesh& mesh, std::size_t meetings) {
    return {carver.take<LightLine>(mesh.edges.size()), carver.take<Meeting>(meetings)};
}

template <int Limbs>
int sign_of(const fixed::WideInt<Limbs>& v) {
    return v.is_negative() ? -1 : v.is_zero() ? 0 : 1;
}

// The determinant's sign, of numbers that have so many limbs: by products of two and of three,
// which always fit.
template <int Limbs>
int determinant_sign(const LightLine& a, const LightLine& b, const LightLine& c) {
    using Number = fixed::WideInt<Limbs>;
    const auto product = [&](std::size_t j, std::size_t k) {
        return full_product(Number(a.v[j]), Number(b.v[k]));
    };
    const auto term = [&](std::size_t i, std::size_t j, std::size_t k) {
        return full_product(Number(c.v[i]), product(j, k) - product(k, j));
    };
    return sign_of(term(0, 1, 2) + term(1, 2, 0) + term(2, 0, 1));
}

}  // namespace

// --- the sign of three lines ----------------------------------------------------------------

// A number is its leading bits plus less than 1, in units of its line's 2^s. So of the six products
// that make up the determinant each is within (M + 1)^3 - M^3 of that of the leading bits, where M
// is the greatest of them. A determinant beyond six times that has its sign.
int sign_by_leading(const LightLine& a, const LightLine& b, const LightLine& c) {
    constexpr std::int64_t most = std::int64_t{1} << leading_bits;
    constexpr std::int64_t error = 6 * (3 * most * (most + 1) + 1);
    static_assert(most * most <= INT64_MAX / 6 / most);
    const LeadingBits &u = a.leading, &v = b.leading, &w = c.leading;
    const auto minor = [&](std::size_t i, std::size_t j) {
        return std::int64_t{u[i]} * v[j] - std::int64_t{u[j]} * v[i];
    };
    const std::int64_t det = w[0] * minor(1, 2) + w[1] * minor(2, 0) + w[2] * minor(0, 1);
    return det > error ? 1 : det < -error ? -1 : 0;
}

int sign_by_all_bits(const LightLine& a, const LightLine& b, const LightLine& c) {
    const int limbs = std::max({a.limbs, b.limbs, c.limbs});
    if (limbs == 1) return determinant_sign<1>(a, b, c);
    return limbs == 2 ? determinant_sign<2>(a, b, c) : determinant_sign<3>(a, b, c);
}

// --- on the screen --------------------------------------------------------------------------

// Ties as in planes.hpp.
int ShownLine::sign_at(std::int64_t px, std::int64_t py) const {
    const int s = sign_of(x * px + y * py + c);
    if (s != 0) return s;
    return !x.is_zero() ? sign_of(x) : sign_of(y);
}

// Along a row the sign changes once at most.
Run ShownLine::inside(const Space& space, const Run& run, int row) const {
    if (run.empty()) return run;
    const auto is_inside = [&](int column) {
        return sign_at(space.centre(column), space.centre(row)) > 0;
    };
    const bool first = is_inside(run.from), last = is_inside(run.to - 1);
    if (first == last) return first ? run : Run{run.from, run.from};
    int before = run.from, after = run.to - 1;
    while (after - before > 1) {
        const int middle = before + (after - before) / 2;
        (is_inside(middle) == first ? before : after) = middle;
    }
    return first ? Run{run.from, after} : Run{after, run.to};
}

// --- the lines ------------------------------------------------------------------------------

std::size_t LightLines::bytes(const Mesh& mesh, std::size_t meetings) {
    Carver carver(static_cast<std::byte*>(nullptr));
    lay_out(carver, mesh, meetings);
    return carver.used();
}

bool LightLines::make(const Setting& setting, std::size_t meetings, std::span<std::byte> memory) {
    Carver carver(memory);
    const auto [edges, room] = lay_out(carver, setting.mesh, meetings);
    if (!carver.fits()) return false;
    setting_ = &setting;
    edges_ = edges, meetings_ = room;
    used_ = most_ = 0;
    const Mesh& mesh = setting.mesh;
    for (std::size_t e = 0; e < edges.size(); ++e) {
        const Edge& edge = mesh.edges[e];
        const Plane plane = plane_through(setting.light.centre, mesh.vertices[edge.low],
                                          mesh.vertices[edge.high]);
        edges_[e] = LightLine(numbers(plane), longer());
    }
    return true;
}

std::array<Sum, 3> LightLines::numbers(const Plane& plane) const {
    const Centre& light = setting_->light.centre;
    if (light.w != 0) return {plane.n[0], plane.n[1], plane.n[2]};
    const auto [d, a, b] = LightPicture(light).axes();
    return {plane.n[a], plane.n[b], plane.d};
}

LineId LightLines::side(std::uint32_t facet, std::size_t k) const {
    const Mesh& mesh = setting_->mesh;
    return LineId::edge(mesh.sides[facet][k] / 2, setting_->light.inside(mesh, facet, k));
}

std::array<LineId, 3> LightLines::outline(std::uint32_t facet, SignCounts& counts) const {
    const LineId a = side(facet, 0), b = side(facet, 1), c = side(facet, 2);
    return sign(a, b, c, counts) > 0 ? std::array{a, b, c} : std::array{a, c, b};
}

LineId LightLines::meeting(std::uint32_t on, std::uint32_t other, int side) {
    const std::size_t index = used_++;
    most_ = std::max(most_, used_);
    if (index >= meetings_.size()) return {};
    const Plane f = setting_->mesh.plane(other);
    const Centre& light = setting_->light.centre;
    meetings_[index] = {on, other, setting_->mesh.plane(on).at(light), f.at(light),
                        where_cut(on, f)};
    // On A the line's value is that of F times A . L.
    return LineId::meeting(static_cast<std::uint32_t>(index), side * setting_->light.sides[on]);
}

LightLine LightLines::where_cut(std::uint32_t on, const Plane& plane) const {
    const Plane a = setting_->mesh.plane(on);
    const Centre& light = setting_->light.centre;
    const Sum at_a = a.at(light), at_f = plane.at(light);
    const auto va = numbers(a), vf = numbers(plane);
    std::array<Sum, 3> v;
    for (std::size_t k = 0; k < 3; ++k) v[k] = at_a * vf[k] - at_f * va[k];
    return LightLine(v, longer());
}

const LightLine& LightLines::line(LineId id) const {
    return id.is_meeting() ? meetings_[id.index()].line : edges_[id.index()];
}

int LightLines::sign(LineId a, LineId b, LineId c, SignCounts& counts) const {
    const bool wide = a.is_meeting() || b.is_meeting() || c.is_meeting();
    ++(wide ? counts.meetings : counts.edges);
    int s = sign_by_leading(line(a), line(b), line(c));
    if (s == 0) s = sign_by_all_bits(line(a), line(b), line(c));
    return s * a.inside() * b.inside() * c.inside();
}

// The plane lambda at the points of the facet `on`.
ShownLine LightLines::shown(std::uint32_t on, LineId id) const {
    const Setting& s = *setting_;
    const SeenPlane& plane = s.planes[on];
    using Word = ShownLine::Word;
    const Word inside = id.inside();
    if (!id.is_meeting()) {
        const ScreenLine l = meet(plane, s.light.edges[id.index()]);
        return {Word(l.x) * inside, Word(l.y) * inside, Word(l.c) * inside};
    }
    const Meeting& m = meetings_[id.index()];
    const ScreenLine f = meet(plane, s.planes[m.other]), a = meet(plane, s.planes[m.on]);
    const Word at_a = Word(m.on_at_light) * inside, at_f = Word(m.other_at_light) * inside;
    return {at_a * Word(f.x) - at_f * Word(a.x), at_a * Word(f.y) - at_f * Word(a.y),
            at_a * Word(f.c) - at_f * Word(a.c)};
}

}  // namespace umbra78::shadow::rivals
