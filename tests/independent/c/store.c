/* Section 8: the frame store, and how surfaces are drawn into it (sections 6 and 14). */
#include <string.h>

#include "machine.h"

enum { MOST_SPLITS = 24, MOST_SPLITS_OF_PATCH = 1 << 20 };
typedef struct { Component screen[4], object[3]; } Block;

/* The levels of a sample, and its kept normal after those and the masks. */
static void shade_sample(Drawing *d, const bool *shadowed, int32_t *planes) {
  const Shading *sh = d->shading;
  i64 normal[3] = {0, 0, 0}, place[3] = {0, 0, 0};
  bool needs = sh->rule != UNSHADED;
  int32_t *kept = planes + sh->channels * (1 + sh->sources) + d->masks;
  if (d->facet) {
    if (needs) facet_normal(d, normal, place);
    shade(sh, normal, place, true, shadowed, planes);
    i64 to_viewer[3], first[3];
    for (int k = 0; k < 3; ++k) first[k] = 1024 * 64 * d->facet->p[0][k];
    direction(&sh->viewer, first, to_viewer);
    if (sh->kept) kept_normal(d->own, to_viewer, kept);
    return;
  }
  for (int k = 0; k < 3 && (needs || sh->kept); ++k) {
    const i64 n[4] = {d->normals[0][k], d->normals[1][k], d->normals[2][k], d->normals[3][k]};
    normal[k] = at_leaf(n, d->leaf_i, d->leaf_j);
    place[k] = at_leaf(d->object[k].v[F], d->leaf_i, d->leaf_j);
  }
  shade(sh, normal, place, false, shadowed, planes);
  if (!sh->kept) return;
  const i128 wide[3] = {normal[0], normal[1], normal[2]};
  i64 cut[3], to_viewer[3];
  cut_to(wide, 14, cut);
  direction(&sh->viewer, place, to_viewer);
  kept_normal(cut, to_viewer, kept);
}

static void put_record(Drawing *d, const Sample *sample, i64 code) {
  int32_t *stored = d->records + (sample->py * d->s->size_px + sample->px) * d->record_words;
  int32_t fresh[96];
  bool shadowed[64];
  if (code > stored[0]) return;
  int levels = d->shading->channels * (1 + d->shading->sources);
  for (int l = 0; d->tests && l < d->masks; ++l)
    shadowed[l] = correct_shadow(d->tests, l, sample, code);
  if (d->tests || d->facet || !d->shaded) {
    shade_sample(d, d->tests ? shadowed : NULL, d->planes);
    d->shaded = !d->tests && !d->facet;
  }
  for (int l = 0; l < d->masks; ++l) d->planes[levels + l] = shadowed[l] ? 255 : 0;
  fresh[0] = (int32_t)code;
  memcpy(fresh + 1, d->planes, (size_t)(d->record_words - 1) * sizeof *fresh);
  for (int k = 0; k < d->record_words; ++k) {
    if (fresh[k] == stored[k]) continue;
    if (fresh[k] > stored[k]) return;
    memcpy(stored, fresh, (size_t)d->record_words * sizeof *fresh);
    for (int l = 0; l < d->cleared_masks; ++l)
      d->mask[l * d->s->pixels + sample->py * d->s->size_px + sample->px] = 0;
    return;
  }
}

void put(Drawing *d, const Sample *sample) {
  i64 code = z_code(sample->z, d->s), pixel = sample->py * d->s->size_px + sample->px;
  if (code < 0) return;
  ++d->counts.samples;
  if (d->places) {
    Place *p = d->places->places + sample->place;
    if (code < p->least) p->least = code;
  } else if (d->light) {
    keep_two(d->records + 2 * pixel, moved_code(sample->z, sample->rise, d->s));
  } else if (d->shading) {
    put_record(d, sample, code);
  } else if (d->records[pixel * d->record_words] != d->s->background_code) {
    d->mask[pixel] = 255;
  }
}

static void draw_block(Drawing *d, const Block *b) {
  i64 grid[4][17][17];
  Corner corners[17][17];
  for (int k = 0; k < (d->m.affine ? 3 : 4); ++k) leaf_corners(b->screen + k, grid[k]);
  for (int i = 0; i <= 16; ++i)
    for (int j = 0; j <= 16; ++j) {
      i64 place[4] = {grid[0][i][j], grid[1][i][j], grid[2][i][j], d->m.affine ? 1 : grid[3][i][j]};
      corners[i][j] = (Corner){place[0], place[1], place[2]};
      if (!d->m.affine && !divide_place(place, d->s, &corners[i][j])) return;
    }
  d->object = b->object;
  if (d->shading && (d->shading->rule != UNSHADED || d->shading->kept))
    corner_normals(b->object, d->normals);
  draw_leaves(d, corners);
}

static Fate fate(const Drawing *d, const Block *b, const int splits[2]) {
  Bounds found[3];
  if (!d->m.affine) return perspective_rule(b->screen, splits, d->s);
  for (int k = 0; k < 3; ++k) found[k] = bounds(b->screen + k);
  return block_rule(found, d->s);
}

static void visit_block(Drawing *d, const Block *b, int u, int v, int *splits) {
  int split_before[2] = {u, v};
  ++d->counts.tested;
  Fate found = fate(d, b, split_before);
  if (found == OUTSIDE) return;
  if (found == DRAW) {
    ++d->counts.drawn;
    draw_block(d, b);
    return;
  }
  int way = found == SPLIT_V;
  if (split_before[way] == MOST_SPLITS) way = !way;
  if (split_before[way] == MOST_SPLITS || *splits == MOST_SPLITS_OF_PATCH) return;
  Block low, high;
  ++*splits;
  ++d->counts.splits;
  for (int k = 0; k < (d->m.affine ? 3 : 4); ++k)
    split(b->screen + k, way, low.screen + k, high.screen + k);
  for (int k = 0; k < 3 && d->shading; ++k)
    split(b->object + k, way, low.object + k, high.object + k);
  visit_block(d, &high, u + !way, v + way, splits);
  visit_block(d, &low, u + !way, v + way, splits);
}

static void draw_patch(Drawing *d, const Patch *patch) {
  i64 words[4][16], object[3][16];
  Block b;
  for (int n = 0; n < 16; ++n) {
    i64 place[4];
    screen_words(&d->m, d->s, patch->p[n], place);
    for (int k = 0; k < 4; ++k) words[k][n] = place[k];
    for (int k = 0; k < 3; ++k) object[k][n] = 64 * patch->p[n][k];
  }
  for (int k = 0; k < (d->m.affine ? 3 : 4); ++k) b.screen[k] = component(words[k]);
  for (int k = 0; k < 3; ++k) b.object[k] = component(object[k]);
  int splits = 0;
  visit_block(d, &b, 0, 0, &splits);
}

void draw(Drawing *d, const Surfaces *surfaces) {
  const i64 out[3] = {13, 13, d->s->depth_fraction + d->s->depth_guard};
  for (int r = 0; r < 3 && d->m.affine; ++r)
    if (d->m.e[r] > 37 + d->fraction - out[r]) fail("a view's matrix is refused (section 6)");
  d->facet = NULL;
  for (int n = 0; n < surfaces->n_patches; ++n) draw_patch(d, surfaces->patches + n);
  for (int n = 0; n < surfaces->n_facets; ++n) draw_facet(d, surfaces->facets + n);
}
