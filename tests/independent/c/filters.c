/* Section 13: filters and composite. Section 23: Crow's ramp. */
#include <stdlib.h>

#include "machine.h"

enum { NODE = 4096, EAST = 0 };
typedef struct {
  int x, y, heading;
} Step;
static const int dx[4] = {1, 0, -1, 0}, dy[4] = {0, 1, 0, -1}; /* east, south, west, north */

typedef struct {
  const int32_t *mask;
  const bool *visible;
  int size;
} Frame;

static bool within(const Frame *f, int x, int y) {
  return x >= 0 && y >= 0 && x < f->size && y < f->size;
}
static bool dark(const Frame *f, int x, int y) {
  return within(f, x, y) && f->mask[y * f->size + x] >= 128;
}
static bool seen(const Frame *f, int x, int y) {
  return within(f, x, y) && f->visible[y * f->size + x];
}

/* The pixel ahead on the right hand (side 1) or the left (side -1) of a corner. */
static bool ahead(const Frame *f, const Step *at, int side) {
  int right = (at->heading + 1) % 4;
  int x = 2 * at->x + dx[at->heading] + side * dx[right],
      y = 2 * at->y + dy[at->heading] + side * dy[right];
  return dark(f, (x - 1) / 2, (y - 1) / 2); /* x and y are odd */
}

/* A chain's corners, from a shadow pixel without a shadow above it. */
static int follow(const Frame *f, int x, int y, bool *passed, i64 (**nodes)[2], int *room) {
  Step at = {x, y, EAST};
  int count = 0;
  do {
    if (count == *room) {
      *room = 2 * *room + 64;
      *nodes = realloc(*nodes, (size_t)*room * sizeof **nodes);
      if (!*nodes) fail("out of memory");
    }
    (*nodes)[count][0] = at.x;
    (*nodes)[count++][1] = at.y;
    if (at.heading == EAST) passed[at.y * f->size + at.x] = true;
    at.x += dx[at.heading];
    at.y += dy[at.heading];
    if (!ahead(f, &at, 1))
      at.heading = (at.heading + 1) % 4;
    else if (ahead(f, &at, -1))
      at.heading = (at.heading + 3) % 4;
  } while (at.x != x || at.y != y || at.heading != EAST);
  return count;
}

static void smooth(const Frame *f, i64 (*nodes)[2], int count, int passes) {
  bool *pinned = zeroed((size_t)count, 1);
  i64(*next)[2] = zeroed((size_t)count, sizeof *next);
  for (int n = 0; n < count; ++n) {
    int x = (int)nodes[n][0], y = (int)nodes[n][1];
    pinned[n] =
        !seen(f, x, y) || !seen(f, x - 1, y) || !seen(f, x, y - 1) || !seen(f, x - 1, y - 1);
    for (int k = 0; k < 2; ++k) nodes[n][k] *= NODE;
  }
  for (; passes > 0; --passes) {
    for (int n = 0; n < count; ++n)
      for (int k = 0; k < 2; ++k)
        next[n][k] = pinned[n] ? nodes[n][k]
                               : (nodes[(n + count - 1) % count][k] + 2 * nodes[n][k] +
                                  nodes[(n + 1) % count][k]) /
                                     4;
    for (int n = 0; n < count; ++n)
      for (int k = 0; k < 2; ++k) nodes[n][k] = next[n][k];
  }
  free(pinned);
  free(next);
}

static void cover(const i64 from[2], const i64 to[2], int size, i64 *cells) {
  const i64 *top = from[1] < to[1] ? from : to, *end = from[1] < to[1] ? to : from;
  int sign = to[1] < from[1] ? 1 : -1;
  for (i64 r = (top[1] + 127) >> 8; 256 * r + 128 < end[1]; ++r) {
    i64 x =
        top[0] + (i64)divide((256 * r + 128 - top[1]) * (end[0] - top[0]), end[1] - top[1], FLOOR);
    i64 step = (x + 128) >> 8, cell = step >> 4, part = step & 15;
    if (cell < size) cells[(r >> 4) * size + cell] += sign * (16 - part);
    if (cell + 1 < size) cells[(r >> 4) * size + cell + 1] += sign * part;
  }
}

void dequantize(const int32_t *mask, const bool *visible, int passes, int size, int32_t *out) {
  const Frame f = {mask, visible, size};
  bool *passed = zeroed((size_t)(size * size), 1);
  i64 *cells = zeroed((size_t)(size * size), sizeof *cells), (*nodes)[2] = NULL, sum = 0;
  int room = 0;
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) {
      if (!dark(&f, x, y) || dark(&f, x, y - 1) || passed[y * size + x]) continue;
      int count = follow(&f, x, y, passed, &nodes, &room);
      smooth(&f, nodes, count, passes);
      for (int n = 0; n < count; ++n) cover(nodes[n], nodes[(n + 1) % count], size, cells);
    }
  for (int p = 0; p < size * size; ++p) {
    sum = (p % size ? sum : 0) + cells[p];
    out[p] = visible[p] ? (int32_t)((255 * (i64)clamp(sum, 0, 256) + 128) >> 8) : 0;
  }
  free(passed);
  free(cells);
  free(nodes);
}

void low_pass(const int32_t *in, const bool *visible, int size, int32_t *out) {
  const Frame f = {in, visible, size};
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) {
      i64 sum = 8;
      for (int j = -1; j <= 1; ++j)
        for (int i = -1; i <= 1; ++i) {
          int from = seen(&f, x + i, y + j) ? (y + j) * size + x + i : y * size + x;
          sum += (2 - (i != 0)) * (2 - (j != 0)) * in[from];
        }
      out[y * size + x] = visible[y * size + x] ? (int32_t)(sum >> 4) : 0;
    }
}

i64 darken(i64 out, i64 share, i64 mask, i64 density) {
  return (i64)divide((i128)65280 * out - (i128)share * mask * density + 32640, 65280, FLOOR);
}

void ramp(int32_t *mask, const bool *visible, int w, int size) {
  int32_t *given = zeroed((size_t)(size * size), sizeof *given);
  const Frame f = {given, visible, size};
  for (int p = 0; p < size * size; ++p) given[p] = mask[p];
  for (int p = 0; p < size * size; ++p) {
    i64 least = w * w, level = 0;
    for (int j = -w; j <= w; ++j)
      for (int i = -w; i <= w; ++i)
        if (i * i + j * j < least && dark(&f, p % size + i, p / size + j)) least = i * i + j * j;
    if (least < w * w) level = half_up(255 * (256 * w - (i128)isqrt((u128)least << 16)), 256 * w);
    mask[p] = !visible[p] ? 0 : level > given[p] ? (int32_t)level : given[p];
  }
  free(given);
}
