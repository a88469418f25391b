/* Section 2: the settings, read from its table, and the widths that follow from them. Section 3's
 * decimals. The tables of the text. */
#include <stdlib.h>
#include <string.h>

#include "machine.h"

static char *piece(const char *from, const char *to) {
  while (from < to && *from == ' ') ++from;
  while (from < to && to[-1] == ' ') --to;
  char *text = zeroed((size_t)(to - from) + 1, 1);
  memcpy(text, from, (size_t)(to - from));
  return text;
}

/* The cells of all tables whose first line starts with `head`. */
Row *table(const char *text, const char *head, int *count) {
  Row *rows = NULL;
  bool inside = false;
  *count = 0;
  for (const char *line = text, *end; *line; line = *end ? end + 1 : end) {
    end = strchr(line, '\n');
    if (!end) end = line + strlen(line);
    if (!strncmp(line, head, strlen(head))) {
      inside = true;
    } else if (*line != '|') {
      inside = false;
    } else if (inside && strncmp(line, "|---", 4)) {
      Row row = {.cells = 0};
      for (const char *cell = line + 1; cell < end && row.cells < 8; ++row.cells) {
        const char *bar = memchr(cell, '|', (size_t)(end - cell));
        row.cell[row.cells] = piece(cell, bar ? bar : end);
        cell = bar ? bar + 1 : end;
      }
      rows = realloc(rows, (size_t)(*count + 1) * sizeof *rows);
      if (!rows) fail("out of memory");
      rows[(*count)++] = row;
    }
  }
  return rows;
}

i64 decimal(const char *written, int fraction_bits) {
  const char *at = written;
  bool negative = *at == '-';
  at += negative;
  Big digits = big(0), one = big(1);
  int exponent = 0;
  for (bool point = false; (*at >= '0' && *at <= '9') || (*at == '.' && !point); ++at) {
    if (*at == '.') {
      point = true;
      continue;
    }
    digits = big_add(times(digits, 10), big(*at - '0'));
    exponent -= point;
  }
  if (*at == 'e') exponent += (int)strtol(at + 1, (char **)&at, 10);
  if (*at || at == written + negative) fail("not a decimal: %s", written);
  for (; exponent < 0; ++exponent) one = times(one, 10);
  for (; exponent > 0; --exponent) digits = times(digits, 10);
  if (negative) digits.sign = -digits.sign;
  return (i64)big_round(big_shift(digits, fraction_bits), one, HALF_EVEN);
}

#define ROUNDINGS "floor ceiling to_zero half_up half_to_zero half_away half_even"
#define S(key, fraction, choices) {#key, offsetof(Settings, key), fraction, choices}
static const struct {
  const char *key;
  size_t offset;
  int fraction;
  const char *choices;
} keys[] = {
    S(xy_bits, 0, ""), S(z_bits, 0, ""), S(coefficient_bits, 0, ""), S(fraction_bits, 0, ""),
    S(accumulator_bits, 0, ""), S(product_rounding, 0, ROUNDINGS),
    S(transform_rounding, 0, ROUNDINGS), S(coefficient_rounding, 0, ROUNDINGS),
    S(depth_rounding, 0, ROUNDINGS), S(divide_order, 0, "exact round_first"),
    S(surface, 0, "catmull diced"), S(dice_levels, 0, ""), S(facing, 0, "both front"),
    S(sampling, 0, "leaf centre"), S(registration, 0, "centre index"),
    S(lookup, 0, "nearest bilinear percentage filtered_depth"),
    S(background, 0, "blend fall_back"), S(taps, 0, ""), S(tap_places, 0, "grid jittered"),
    S(bias, 16, ""), S(bias_unit, 0, "quanta texels world"),
    S(map_depth, 0, "first back midpoint"), S(bias_slope, 8, ""), S(bias_clamp, 16, ""),
    S(receiver, 0, "point plane normal"), S(normal_offset, 8, ""),
    S(slope_source, 0, "depths normals"),
    S(dither, 0, "none uniform triangular normal4 normal"), S(dither_size, 8, ""),
    S(dither_seed, 0, ""), S(dequantize, 0, ""), S(low_pass, 0, ""), S(ambient, 8, ""),
    S(shading, 0, "phong blinn lambert none"), S(composite, 0, "direct whole"),
    S(density, 8, ""), S(form, 0, "post_process correct ground blob irregular_map"),
    S(arithmetic, 0, "fixed ap120b")};
enum { KEYS = sizeof keys / sizeof *keys };
/* Those on which no bit depends (section 2), and the clock's and the memory's. */
static const char *const idle[] = {"multipliers", "array_memory", "sector_test"};

static int number_of(const char *word, const char *words) {
  size_t length = strlen(word);
  for (int n = 0; *words; ++n) {
    size_t next = strcspn(words, " ");
    if (next == length && !strncmp(words, word, length)) return n;
    words += next + (words[next] == ' ');
  }
  return -1;
}

static bool assign(Settings *s, const char *key, const char *value) {
  for (int k = 0; k < KEYS; ++k)
    if (!strcmp(keys[k].key, key)) {
      const char *choices = keys[k].choices;
      i64 word = *choices ? number_of(value, choices) : decimal(value, keys[k].fraction);
      if (*choices && word < 0) fail("setting %s has no choice %s", key, value);
      *(i64 *)(void *)((char *)s + keys[k].offset) = word;
      return true;
    }
  return false;
}

void set(Settings *s, const char *key, const char *value) {
  if (assign(s, key, value)) return;
  for (size_t k = 0; k < sizeof idle / sizeof *idle; ++k)
    if (!strcmp(idle[k], key)) return;
  fail("section 2 has no setting %s that a picture depends on", key);
}

static Settings from_text;

void read_defaults(const char *text) {
  int count, found = 0;
  Row *rows = table(text, "| setting | default | range |", &count);
  for (int k = 0; k < count; ++k)
    if (rows[k].cells > 1) found += assign(&from_text, rows[k].cell[0], rows[k].cell[1]);
  if (found != KEYS) fail("section 2 lists %d of the %d settings used here", found, (int)KEYS);
  widths(&from_text);
}

Settings defaults(void) { return from_text; }

void widths(Settings *s) {
  s->size_px = 1 << s->xy_bits;
  s->half_px = s->size_px / 2;
  s->pixels = s->size_px * s->size_px;
  s->depth_fraction = s->z_bits - s->xy_bits;
  s->depth_offset = (i64)1 << (s->z_bits - 1);
  s->background_code = ((i64)1 << s->z_bits) - 1;
  s->deepest_drawn = s->background_code - 1;
  s->input_fraction = s->depth_fraction > 1 ? s->depth_fraction : 1;
  s->word_bits = s->xy_bits + s->input_fraction;
  s->one_word = (i64)1 << (s->word_bits - 2);
  i64 needed = s->word_bits + s->coefficient_bits + 3;
  s->dropped_bits = needed > s->accumulator_bits ? needed - s->accumulator_bits : 0;
  s->depth_guard = s->z_bits > 20 ? 26 - s->z_bits : 6;
  s->one_texel = (i64)1 << s->fraction_bits;
}

Settings settings(const char *written) {
  Settings s = defaults();
  s.ambient = 90;
  for (const char *at = written; *at;) {
    size_t length = strcspn(at, ",");
    char *pair = piece(at, at + length), *space = strchr(pair, ' ');
    if (!space) fail("no value: %s", pair);
    *space = 0;
    set(&s, pair, space + 1);
    free(pair);
    at += length + (at[length] == ',');
  }
  widths(&s);
  return s;
}
