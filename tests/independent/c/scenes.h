/* The scenes, views and sources that section 15 lists. */
#ifndef SCENES_H
#define SCENES_H
#include "machine.h"

typedef struct {
  char name[16];
  Patch patches[129]; /* world words; the last of a scene with a floor is the ground */
  int n_patches;
  bool floor;
  Facet facets[16];
  int n_facets;
  i64 points[129 * 16 + 13][3]; /* all control points and vertices */
  int n_points;
} Scene;
typedef struct {
  View place, views[6];
  int n_views, ramp;
  bool sectored, coloured;
  i64 level[3], p[3]; /* p: where a sectored source stands */
} Source;

enum { SOURCES = 8, LIGHTS = 64 };
typedef struct {
  Settings s;
  Scene scene;
  Surfaces all, ground, others, blobs; /* in object words */
  int fraction, n_sources, n_lights, channels, record_words;
  bool kept;
  View observer, views[LIGHTS];
  Source sources[SOURCES];
  Light lights[LIGHTS];
  int32_t *records, *dither, *observer_z, *normals[3], *maps[LIGHTS], *masks;
  bool *visible;
  int32_t *darkness[SOURCES], *edges[SOURCES], *filtered[SOURCES];
  Shading shading;
  Counts counts[2]; /* of the observer's view and of the first light's */
} Frame;
void make_frame(Frame *f); /* of s, scene, observer, sources and views */
void free_frame(Frame *f);
bool reuse(const Frame *f, const View *v, const Shading *shading, int words, int32_t *planes,
           Counts *counts);
void keep(const Frame *f, const View *v, const Shading *shading, int words, const int32_t *planes,
          Counts counts);

void make_scene(const char *name, Scene *s);
View make_view(const char *name, Scene *s);
Source make_source(const char *written, Scene *s);
#endif
