/* Section 3: sines, patches, object words. */
#include "machine.h"

i64 mul30(i64 a, i64 b) { return half_even((i128)a * b, power(30)); }

/* Sine or cosine of 0 .. 45 degrees by the series, to 2^-58 or better, rounded to Q2.30. */
static i64 series(i64 angle, bool cosine) {
  const i128 pi = (i128)0x3243f6a888 << 64 | 0x5a308d313198a2e0; /* 2^100 pi */
  i128 x = angle * pi / ((i128)180 * 65536 * power(38));         /* Q62 */
  i128 term = cosine ? power(62) : x, sum = term;
  for (int n = cosine ? 1 : 2; term; n += 2) {
    term = -down(down(term * x, 62, HALF_UP) * x, 62, HALF_UP) / (n * (n + 1));
    sum += term;
  }
  i128 rest = sum & (power(32) - 1);
  if (magnitude(rest - power(31)) < 64) fail("an angle's sine is too near a tie");
  return (i64)down(sum, 32, HALF_UP);
}

void sine_cosine(i64 angle, i64 *sine, i64 *cosine) {
  const i64 turn = 360 * 65536, quarter = turn / 4;
  i64 a = ((angle % turn) + turn) % turn, quadrant = a / quarter;
  a %= quarter;
  bool upper = a > quarter / 2;
  i64 small = upper ? quarter - a : a;
  i64 s = series(small, upper), c = series(small, !upper);
  *sine = quadrant == 0 ? s : quadrant == 1 ? c : quadrant == 2 ? -s : -c;
  *cosine = quadrant == 0 ? c : quadrant == 1 ? -s : quadrant == 2 ? -c : s;
}

void arc(int k, int point, i64 *sine, i64 *cosine) {
  const i64 handle = 284774038;
  i64 s, c;
  int end = k + (point > 1);
  sine_cosine((i64)45 * 65536 * end, &s, &c);
  i64 h = point == 1 ? handle : point == 2 ? -handle : 0;
  *sine = s + mul30(h, c);
  *cosine = c - mul30(h, s);
}

Patch sphere_patch(const i64 centre[3], i64 radius, int number) {
  Patch patch;
  for (int j = 0; j < 4; ++j)
    for (int i = 0; i < 4; ++i) {
      i64 su, cu, sv, cv;
      arc(number % 8, i, &su, &cu);
      arc(number / 8 - 2, j, &sv, &cv);
      i64 *p = patch.p[4 * j + i];
      p[0] = centre[0] + mul30(radius, mul30(su, cv));
      p[1] = centre[1] + mul30(radius, mul30((i64)1 << 30, sv));
      p[2] = centre[2] + mul30(radius, mul30(cu, cv));
    }
  return patch;
}

Patch plane_patch(const i64 origin[3], const i64 u[3], const i64 v[3]) {
  Patch patch;
  for (int n = 0; n < 16; ++n)
    for (int k = 0; k < 3; ++k)
      patch.p[n][k] = origin[k] + half_even((i128)u[k] * (n % 4), 3) +
                      half_even((i128)v[k] * (n / 4), 3);
  return patch;
}

int object_fraction(i64 largest) {
  int fraction = 14;
  while (fraction > 0 && object_word(largest, fraction) > 32767) --fraction;
  return fraction;
}

i64 object_word(i64 world, int fraction) { return (i64)down(world, 16 - fraction, HALF_UP); }
