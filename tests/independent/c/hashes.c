/* Section 15: the hashes of the text, each compared with that of the buffer as it is drawn here.
 * Section 6's block counts. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "machine.h"
#include "scenes.h"

static const char four[] = "lookup bilinear, bias 192, dither normal";

/* The figures' frames: their buffers' names in the text, and what those are. */
static const struct { const char *name, *buffer, *settings; bool like_four; } figures[] = {
    {"intensity", "intensity", "", false}, {"direct", "direct", "", false},
    {"observer_z", "observer_z", "", false}, {"light_z", "light_z", "", false},
    {"mask3", "mask", "", false},
    {"mask4", "mask", "dequantize 1, low_pass 2", true},
    {"edges5", "edges", "dequantize 1, low_pass 2", true},
    {"filtered5", "filtered", "dequantize 1, low_pass 2", true},
    {"picture6", "picture", "dequantize 1, low_pass 2", true},
    {"mask3_short", "mask", "accumulator_bits 22", false},
    {"mask3_shorter", "mask", "accumulator_bits 16, product_rounding half_up, bias 100", false},
    {"mask3_ap120b", "mask", "arithmetic ap120b", false},
    {"mask4_ap120b", "mask", "arithmetic ap120b", true}};

/* A buffer by its name: a plane, numbered by lights or sources, in colour with its channel. */
static int32_t *buffer_of(const Frame *f, const char *name, int32_t *made) {
  static const char *const channels[3] = {"_red", "_green", "_blue"};
  char stem[32];
  int number = 0, channel = 0;
  size_t length = strcspn(name, "0123456789");
  if (length >= sizeof stem) fail("no buffer: %s", name);
  memcpy(stem, name, length + 1);
  stem[length] = 0;
  if (name[length]) number = (int)strtol(name + length, NULL, 10) - 1;
  for (int c = 0; c < 3; ++c) {
    const char *at = strstr(name, channels[c]);
    if (!at) continue;
    channel = c;
    if ((size_t)(at - name) < length) stem[at - name] = 0;
  }
  i64 pixels = f->s.pixels;
  if (!strcmp(stem, "observer_z")) return f->observer_z;
  if (!strncmp(stem, "normal_", 7)) return f->normals[stem[7] - 'x'];
  if (!strcmp(stem, "light_z")) return f->maps[number];
  if (!strcmp(stem, "mask")) return f->masks + number * pixels;
  if (!strcmp(stem, "darkness")) return f->darkness[number];
  if (!strcmp(stem, "edges")) return f->edges[number];
  if (!strcmp(stem, "filtered")) return f->filtered[number];
  bool direct = !strcmp(stem, "direct"), picture = !strcmp(stem, "picture");
  if (!direct && !picture && strcmp(stem, "intensity")) fail("no buffer: %s", name);
  for (i64 p = 0; p < pixels; ++p) {
    const int32_t *r = f->records + p * f->record_words + 1 + channel * (1 + f->n_sources);
    i64 out = direct ? r[1 + number] : r[0];
    for (int l = 0; picture && f->s.form != CORRECT && l < f->n_sources; ++l)
      out = darken(out, f->s.composite == WHOLE ? out : r[1 + l], f->filtered[l][p], f->s.density);
    made[p] = (int32_t)out;
  }
  return made;
}

static void published_hash(const Frame *f, const char *name, char *hash) {
  static const char *const formats[] = {"", "u8", "u16be", "", "u32be"};
  int32_t *made = zeroed((size_t)f->s.pixels, sizeof *made);
  int size = strstr(name, "_z") && strncmp(name, "normal", 6) ? (f->s.z_bits > 16 ? 4 : 2) : 1;
  if (!strncmp(name, "normal_", 7)) size = 2;
  u64 h = fnv(buffer_of(f, name, made), (size_t)f->s.pixels, size, 0xcbf29ce484222325u);
  sprintf(hash, "`%s:%dx%d:fnv1a64:%016llx`", formats[size], (int)f->s.size_px, (int)f->s.size_px,
          (unsigned long long)h);
  free(made);
}

static Frame *frame_of(const char *scene, const char *observer, const char *lights,
                       const char *written) {
  Frame *f = zeroed(1, sizeof *f);
  f->s = settings(written);
  make_scene(scene, &f->scene);
  f->observer = make_view(observer, &f->scene);
  for (const char *at = lights; *at;) {
    const char *plus = strstr(at, " + ");
    size_t length = plus ? (size_t)(plus - at) : strlen(at);
    char name[64];
    if (length >= sizeof name || f->n_sources == SOURCES) fail("too many lights: %s", lights);
    memcpy(name, at, length);
    name[length] = 0;
    Source *source = f->sources + f->n_sources++;
    *source = make_source(name, &f->scene);
    for (int k = 0; k < source->n_views; ++k) f->views[f->n_lights++] = source->views[k];
    at += length + (plus ? 3 : 0);
  }
  make_frame(f);
  return f;
}

/* Section 6's rows of a frame, if the text has one of that name. */
static int check_counts(const char *text, const Frame *f, const char *name) {
  static const char *const views[2] = {"observer", "light"};
  int wrong = 0;
  for (int k = 0; k < 2; ++k) {
    char head[64], row[192];
    const Counts *c = f->counts + k;
    sprintf(head, "| %.40s, %s |", name, views[k]);
    sprintf(row, "%s %d | %d | %d | %d | %d |\n", head, f->all.n_patches, (int)c->tested,
            (int)c->splits, (int)c->drawn, (int)c->samples);
    if (!strstr(text, head)) continue;
    bool same = strstr(text, row) != NULL;
    printf("%.*s%s\n", (int)strlen(row) - 1, row, same ? "" : "  DIFFERS");
    wrong += !same;
  }
  return wrong;
}

static int compare(const Frame *f, const char *name, const char *buffer, const char *as,
                   const Row *rows, int count, bool figure, int *met) {
  char hash[96];
  published_hash(f, buffer, hash);
  for (int k = 0; k < count; ++k) {
    const Row *r = rows + k;
    if (figure ? r->cells < 5 || strcmp(r->cell[3], as)
               : r->cells < 3 || strcmp(r->cell[0], name) || strcmp(r->cell[1], as))
      continue;
    bool same = !strcmp(r->cell[figure ? 4 : 2], hash);
    printf("%s%s%s %s%s\n", name, *name ? " " : "", as, hash, same ? "" : "  DIFFERS");
    ++*met;
    return !same;
  }
  printf("%s %s %s is not in the text\n", name, as, hash);
  return 1;
}

static int check_figure_rows(const char *text, int *met, int *listed) {
  int count, wrong = 0;
  Row *rows = table(text, "| figure | what | settings | buffer |", &count);
  Frame *f = NULL;
  const char *last = NULL;
  for (int k = 0; k < count; ++k) *listed += rows[k].cells > 4 && rows[k].cell[4][0] == '`';
  for (size_t k = 0; k < sizeof figures / sizeof *figures; ++k) {
    char written[256];
    sprintf(written, "%s%s%s", figures[k].like_four ? four : "",
            figures[k].like_four && *figures[k].settings ? ", " : "", figures[k].settings);
    if (!last || strcmp(last, figures[k].settings) ||
        figures[k].like_four != figures[k - 1].like_four) {
      if (f) free_frame(f), free(f);
      f = frame_of("spheres", "front", "left", written);
      if (!k) wrong += check_counts(text, f, "figures");
    }
    last = figures[k].settings;
    wrong += compare(f, "", figures[k].buffer, figures[k].name, rows, count, true, met);
  }
  free_frame(f), free(f);
  return wrong;
}

static bool wanted(const char *name, char **only, int n_only) {
  for (int k = 0; k < n_only; ++k)
    if (!strcmp(only[k], name)) return true;
  return !n_only;
}

/* Of `parts` processes the one of number `part` does each so-many-th variant. */
int check_figures(const char *text, char **only, int n_only, int part, int parts) {
  int count, n_hashes, wrong = 0, met = 0, listed = 0;
  Row *variants = table(text, "| variant | scene | observer |", &count),
      *hashes = table(text, "| variant | buffer | hash |", &n_hashes);
  if (part == 0 && wanted("figures", only, n_only)) wrong += check_figure_rows(text, &met, &listed);
  for (int k = 0; k < n_hashes; ++k) {
    int of = 0;
    while (of < count && strcmp(variants[of].cell[0], hashes[k].cell[0])) ++of;
    listed += hashes[k].cells > 2 && hashes[k].cell[2][0] == '`' && of % parts == part &&
              wanted(hashes[k].cell[0], only, n_only);
  }
  for (int k = 0; k < count; ++k) {
    Row *r = variants + k;
    if (k % parts != part || r->cells < 6 || !strcmp(r->cell[0], "variant") ||
        !wanted(r->cell[0], only, n_only))
      continue;
    Frame *f = frame_of(r->cell[1], r->cell[2], r->cell[3], r->cell[4]);
    char name[64];
    snprintf(name, sizeof name, "variant %s", r->cell[0]);
    wrong += check_counts(text, f, name);
    for (char *buffer = strtok(r->cell[5], ", "); buffer; buffer = strtok(NULL, ", "))
      wrong += compare(f, r->cell[0], buffer, buffer, hashes, n_hashes, false, &met);
    free_frame(f), free(f);
  }
  if (met != listed) {
    printf("%d of %d hashes of the text are not computed here\n", listed - met, listed);
    return wrong + 1;
  }
  printf("hashes: %d, %d wrong\n", met, wrong);
  return wrong;
}
