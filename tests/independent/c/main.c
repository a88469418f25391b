/* machine [--only NAME]... [--part K/N] VECTORS-FOLDER TEXT...: computes what hw/MACHINE.md and the
 * files of hw/machine/ publish, and compares it. NAME is `vectors`, `figures` or a variant; part K
 * of N, counted from 0, is every N-th variant. Ends with 1 if something differs. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "machine.h"

static char *appended(char *text, const char *path) {
  FILE *file = fopen(path, "rb");
  if (!file) fail("%s: cannot be read; give the files of hw/machine/", path);
  size_t length = strlen(text), got;
  do {
    text = realloc(text, length + 65537);
    if (!text) fail("out of memory");
    got = fread(text + length, 1, 65536, file);
    length += got;
    text[length] = 0;
  } while (got);
  fclose(file);
  return text;
}

int main(int count, char **arguments) {
  char *text = zeroed(1, 1), **only = zeroed((size_t)count, sizeof *only);
  const char *folder = NULL;
  int n_only = 0, wrong = 0, n_texts = 0, part = 0, parts = 1;
  for (int k = 1; k < count; ++k) {
    if (!strcmp(arguments[k], "--only") && k + 1 < count)
      only[n_only++] = arguments[++k];
    else if (!strcmp(arguments[k], "--part") && k + 1 < count) {
      if (sscanf(arguments[++k], "%d/%d", &part, &parts) != 2 || part < 0 || part >= parts)
        fail("--part %s: must be K/N with 0 <= K < N", arguments[k]);
    } else if (!folder)
      folder = arguments[k];
    else
      text = appended(text, arguments[k]), ++n_texts;
  }
  if (!n_texts)
    fail("usage: machine [--only NAME]... VECTORS-FOLDER hw/MACHINE.md hw/machine/*.md");
  read_defaults(text);
  bool vectors = !n_only && part == 0, rest = !n_only;
  for (int k = 0; k < n_only; ++k) {
    if (strcmp(only[k], "vectors"))
      rest = true;
    else
      vectors = true;
  }
  if (vectors) wrong += check_vectors(folder);
  if (rest) wrong += check_figures(text, only, n_only, part, parts);
  return wrong != 0;
}
