/* The vectors of surfaces: patches, blocks, samples, shading, facets, and what follows a slope. */
#include <string.h>

#include "machine.h"

static Settings depths_of(i64 xy_bits, i64 z_bits) {
  Settings s = defaults();
  s.xy_bits = xy_bits;
  s.z_bits = z_bits;
  widths(&s);
  return s;
}

static void patches(Line *l) {
  const char *kind = word(l);
  i64 n[9];
  if (!strcmp(kind, "object")) {
    numbers(l, n, 3);
    int fraction = object_fraction((i64)greater(greater(magnitude(n[0]), magnitude(n[1])),
                                                magnitude(n[2])));
    say(l, fraction);
    for (int k = 0; k < 3; ++k) say(l, object_word(n[k], fraction));
    return;
  }
  bool sphere = !strcmp(kind, "sphere");
  numbers(l, n, sphere ? 5 : 9);
  Patch p = sphere ? sphere_patch(n, n[3], (int)n[4]) : plane_patch(n, n + 3, n + 6);
  says(l, p.p[number(l)], 3);
}

static void say_bounds(Line *l, const Bounds *b) {
  say(l, b->min), say(l, b->max);
  says(l, b->slope, 2), says(l, b->bend, 2);
}

static void corrections(Line *l) {
  i64 p[16];
  numbers(l, p, 16);
  Component c = component(p);
  Bounds b = bounds(&c);
  says(l, c.v[0], 16);
  write_word(l, "bounds");
  say_bounds(l, &b);
}

static void splits(Line *l) {
  int way = *word(l) == 'v';
  Component c, low, high;
  numbers(l, c.v[0], 16);
  split(&c, way, &low, &high);
  says(l, low.v[0], 16), says(l, high.v[0], 16);
}

static void block_rule_vector(Line *l) {
  static const char *const fates[] = {"outside", "u", "v", "draw", "crosses"};
  bool affine = !strcmp(word(l), "affine");
  i64 xy_bits = number(l);
  Settings s = depths_of(xy_bits, number(l));
  Component c[4];
  Bounds b[3];
  for (int k = 0; k < (affine ? 3 : 4); ++k) numbers(l, c[k].v[0], 16);
  if (affine) {
    for (int k = 0; k < 3; ++k) b[k] = bounds(c + k);
    write_word(l, fates[block_rule(b, &s)]);
    return;
  }
  Fate found = quotient_bounds(c, &s, b);
  if (found != DRAW) {
    write_word(l, fates[found]);
    return;
  }
  write_word(l, "bounds");
  for (int k = 0; k < 3; ++k) say_bounds(l, b + k);
  write_word(l, fates[block_rule(b, &s)]);
  write_word(l, huge(b) ? "huge" : "finite");
}

static void corners_of(Line *l, Corner t[3]) {
  for (int k = 0; k < 3; ++k) t[k].x = number(l), t[k].y = number(l), t[k].z = number(l);
}

static void say_or_none(Line *l, bool found, i64 value) {
  if (found) say(l, value);
  else write_word(l, "none");
}

static void samples(Line *l) {
  const char *kind = word(l);
  if (!strcmp(kind, "corners")) {
    static const int places[8][2] = {{0, 0}, {1, 0}, {0, 1}, {7, 3}, {8, 8}, {15, 9}, {16, 15},
                                     {16, 16}};
    Component c;
    i64 grid[17][17];
    numbers(l, c.v[0], 16);
    leaf_corners(&c, grid);
    for (int k = 0; k < 8; ++k) say(l, grid[places[k][0]][places[k][1]]);
  } else if (!strcmp(kind, "triangle")) {
    Corner t[3];
    i64 place[2], z;
    corners_of(l, t);
    numbers(l, place, 2);
    bool found = triangle_depth(t, place[0], place[1], &z);
    say_or_none(l, found, z);
  } else {
    i64 xy_bits = number(l);
    Settings s = depths_of(xy_bits, number(l));
    i64 code = z_code(number(l), &s);
    say_or_none(l, code >= 0, code);
  }
}

static Toward toward_of(Line *l, bool point) {
  Toward t = {.point = point};
  numbers(l, t.words, 3);
  return t;
}

static Shading grey(Line *l, Toward light, Toward viewer) {
  Shading sh = {.sources = 1, .channels = 1, .viewer = viewer, .light = {light},
                .level = {{256, 256, 256}}, .rule = PHONG};
  sh.ambient = number(l);
  sh.diffuse[0] = number(l);
  sh.specular[0] = number(l);
  sh.shininess = number(l);
  return sh;
}

static void leaf_quantities(const Component c[3], int i, int j, i64 normal[3], i64 place[3]) {
  i64 corners[4][3];
  corner_normals(c, corners);
  for (int k = 0; k < 3; ++k) {
    const i64 n[4] = {corners[0][k], corners[1][k], corners[2][k], corners[3][k]};
    normal[k] = at_leaf(n, i, j);
    place[k] = at_leaf(c[k].v[F], i, j);
  }
}

static void shading(Line *l) {
  Component c[3];
  for (int k = 0; k < 3; ++k) numbers(l, c[k].v[0], 16);
  bool point = !strcmp(word(l), "point");
  Toward light = toward_of(l, point), viewer = toward_of(l, false);
  Shading sh = grey(l, light, viewer);
  i64 i = number(l), j = number(l), normal[3], place[3];
  bool shadowed = !strcmp(word(l), "shadow");
  int32_t planes[2];
  leaf_quantities(c, (int)i, (int)j, normal, place);
  shade(&sh, normal, place, false, &shadowed, planes);
  say(l, planes[0]), say(l, planes[1]);
}

static void say_samples(Line *l) {
  Corner t[3];
  corners_of(l, t);
  i64 area = cross(t, t + 1, t[2].x, t[2].y), sum = 0, count = 0, ends[2][3];
  if (area < 0) {
    Corner b = t[1];
    t[1] = t[2];
    t[2] = b;
  }
  for (i64 p = 0; p < 256 && area; ++p) {
    i64 x = (2 * (p % 16 - 8) + 1) * 4096, y = (2 * (p / 16 - 8) + 1) * 4096;
    if (!covered(t, x, y)) continue;
    i64 at[3] = {p % 16, p / 16, plane_depth(t, x, y)};
    if (!count++) memcpy(ends[0], at, sizeof at);
    memcpy(ends[1], at, sizeof at);
    sum += at[2];
  }
  say(l, count);
  if (count) say(l, sum), says(l, ends[0], 6);
}

static void facet_levels(Line *l, bool smooth) {
  bool points = !strcmp(word(l), "points");
  Vertex v[3];
  for (int k = 0; k < 3; ++k) numbers(l, v[k].v, 10);
  Toward light = toward_of(l, points), viewer = toward_of(l, points);
  Shading sh = grey(l, light, viewer);
  i64 x = number(l), y = number(l), normal[3], place[3];
  Corner t[3];
  for (int k = 0; k < 3; ++k) t[k] = (Corner){v[k].v[0], v[k].v[1], v[k].v[2]};
  bool turned = cross(t, t + 1, t[2].x, t[2].y) < 0;
  Facet facet = {.smooth = smooth};
  Drawing d = {.shading = &sh, .facet = &facet};
  for (int k = 0; k < 3; ++k) {
    int from = turned ? (3 - k) % 3 : k;
    d.corners[k] = v + from;
    t[k] = (Corner){v[from].v[0], v[from].v[1], v[from].v[2]};
  }
  own_normal(v, d.own);
  for (int k = 0; k < 3; ++k) d.e[k] = cross(t + (k + 1) % 3, t + (k + 2) % 3, x, y);
  facet_normal(&d, normal, place);
  for (int k = 0; k < 2; ++k) {
    bool shadowed = k;
    int32_t planes[2];
    shade(&sh, normal, place, true, &shadowed, planes);
    say(l, planes[0]), say(l, planes[1]);
  }
}

static void triangles(Line *l) {
  const char *kind = word(l);
  if (!strcmp(kind, "triangle")) {
    say_samples(l);
  } else if (!strcmp(kind, "polygon")) {
    i64 xy_bits = number(l);
    Settings s = depths_of(xy_bits, number(l));
    bool affine = !strcmp(word(l), "affine");
    Vertex in[3], out[10];
    for (int k = 0; k < 3; ++k) numbers(l, in[k].v, 10);
    int count = guard_band(in, affine, &s, out);
    say(l, count);
    for (int k = 0; k < count; ++k) says(l, out[k].v, 10);
  } else {
    facet_levels(l, !strcmp(kind, "smooth"));
  }
}

static void dicing(Line *l) {
  bool vertex = !strcmp(word(l), "vertex");
  i64 first = number(l), n[3] = {first, number(l), 0};
  if (vertex) n[2] = number(l);
  Patch p;
  numbers(l, p.p[0], 48);
  if (vertex) {
    i64 place[3], normal[3];
    diced_vertex(&p, (int)n[1], (int)n[2], 1 << n[0], place);
    diced_normal(&p, (int)n[1], (int)n[2], 1 << n[0], normal);
    says(l, place, 3), says(l, normal, 3);
    return;
  }
  say(l, patch_level(&p, n[1], n[0]));
  for (int edge = 0; edge < 4; ++edge) say(l, edge_level(&p, edge, n[1], n[0]));
}

static Scale scale_of(Line *l, int fraction_bits) {
  Scale s = {.fraction_bits = fraction_bits};
  const char *first = word(l);
  if (strcmp(first, "lamp")) s.quanta = decimal(first, 0);
  else s.reach = number(l), s.focal = number(l);
  return s;
}

static void neighbour_vector(Line *l) {
  Settings s = depths_of(4, 16);
  int32_t z[256];
  i64 n[7];
  numbers(l, n, 7); /* px py dx dy, codes before, of and after the pixel */
  for (int p = 0; p < 256; ++p) z[p] = (int32_t)s.background_code;
  for (int way = -1; way <= 1; ++way) {
    i64 x = n[0] + way * n[2], y = n[1] + way * n[3], code = n[5 + way];
    if (x >= 0 && y >= 0 && x < 16 && y < 16 && code >= 0) z[16 * y + x] = (int32_t)code;
  }
  int found = neighbour(z, &s, n[0], n[1], (int)n[2], (int)n[3]);
  if (!found) write_word(l, "none");
  else say(l, n[0] + found * n[2]), say(l, n[1] + found * n[3]);
}

static i64 limit_of(Line *l) {
  const char *written = word(l);
  return strcmp(written, "none") ? decimal(written, 0) : -1;
}

static void differences(Line *l, i64 at[3], i64 step[2][3]) {
  numbers(l, at, 3);
  numbers(l, step[0], 6);
  for (int k = 0; k < 6; ++k) step[k / 3][k % 3] -= at[k % 3];
}

static void bias(Line *l) {
  const char *kind = word(l);
  i64 at[3], step[2][3];
  if (!strcmp(kind, "offset")) {
    Corner t[3];
    i64 factor = number(l), limit = limit_of(l), slope;
    corners_of(l, t);
    caster_slope(t, &slope);
    say(l, slope), say(l, slope_offset(slope, factor, limit));
  } else if (!strcmp(kind, "moved")) {
    Settings s = depths_of(9, number(l));
    i64 z = number(l), code = moved_code(z, number(l), &s);
    say_or_none(l, code >= 0, code);
  } else if (!strcmp(kind, "plane")) {
    Plane p = {.limit = limit_of(l)};
    differences(l, at, step);
    if (!gradient(step[0], step[1], p.slope)) p.slope[0] = p.slope[1] = 0;
    p.at[0] = at[0], p.at[1] = at[1];
    i64 x = number(l);
    says(l, p.slope, 2), say(l, plane_change(&p, x, number(l)));
  } else if (!strcmp(kind, "neighbour")) {
    neighbour_vector(l);
  } else if (!strcmp(kind, "normal")) {
    i64 fraction_bits = number(l), out[3];
    Scale s = scale_of(l, (int)fraction_bits);
    i64 c = number(l), way = number(l);
    differences(l, at, step);
    moved(at, step[0], step[1], (int)way, c, &s, out);
    says(l, out, 3);
  } else {
    Settings s = depths_of(4, number(l));
    int32_t layers[2] = {(int32_t)s.background_code, (int32_t)s.background_code};
    while (l->at < l->count) keep_two(layers, number(l));
    say(l, midpoint(layers));
  }
}

static void kept_vector(Line *l, bool leaf) {
  Component c[3];
  Vertex v[3];
  i64 n[3], place[3], to_viewer[3];
  int32_t kept[3];
  for (int k = 0; k < 3; ++k) numbers(l, leaf ? c[k].v[0] : v[k].v + 4, leaf ? 16 : 3);
  bool point = !strcmp(word(l), "point");
  Toward viewer = toward_of(l, point);
  if (leaf) {
    i64 i = number(l), normal[3];
    leaf_quantities(c, (int)i, (int)number(l), normal, place);
    const i128 wide[3] = {normal[0], normal[1], normal[2]};
    cut_to(wide, 14, n);
  } else {
    own_normal(v, n);
    for (int k = 0; k < 3; ++k) place[k] = 1024 * v[0].v[4 + k];
  }
  direction(&viewer, place, to_viewer);
  kept_normal(n, to_viewer, kept);
  for (int k = 0; k < 3; ++k) say(l, kept[k]);
}

static void normals(Line *l) {
  const char *kind = word(l);
  i64 n[3], m[3], at[3], out[3], axes[3][3];
  if (!strcmp(kind, "leaf") || !strcmp(kind, "facet")) {
    kept_vector(l, !strcmp(kind, "leaf"));
  } else if (!strcmp(kind, "light")) {
    View v;
    numbers(l, v.right, 3), numbers(l, v.up, 3), numbers(l, v.back, 3), numbers(l, n, 3);
    light_axes(&v, axes);
    in_light(n, axes, m);
    says(l, m, 3);
  } else {
    i64 fraction_bits = number(l);
    Scale s = scale_of(l, (int)fraction_bits);
    numbers(l, m, 3), numbers(l, at, 3);
    if (!strcmp(kind, "moved")) {
      moved_along(at, m, -1, number(l), &s, out);
      says(l, out, 3);
      return;
    }
    Plane p = {.limit = -1, .at = {at[0], at[1]}};
    if (!leaning(at, m, &s, p.slope)) p.slope[0] = p.slope[1] = 0;
    i64 x = number(l);
    says(l, p.slope, 2), say(l, plane_change(&p, x, number(l)));
  }
}

void surface_vector(Line *l, const char *stage) {
  static const struct { const char *name; void (*of)(Line *); } known[] = {
      {"patches", patches}, {"corrections", corrections}, {"splits", splits},
      {"block_rule", block_rule_vector}, {"samples", samples}, {"shading", shading},
      {"triangles", triangles}, {"dicing", dicing}, {"bias", bias}, {"normals", normals}};
  for (size_t k = 0; k < sizeof known / sizeof *known; ++k)
    if (!strcmp(known[k].name, stage)) {
      known[k].of(l);
      return;
    }
  fail("no vectors are known of %s", stage);
}
