/* Section 10: the noise. */
#include "machine.h"

/* x^k modulo x^31 + x^3 + 1 */
static uint32_t power_of_x(u64 k) {
  u64 result = 1, square = 2;
  for (; k; k >>= 1) {
    for (int odd = (int)(k & 1); odd >= 0; --odd) {
      u64 factor = odd ? result : square, wide = 0;
      for (int n = 0; n < 31; ++n)
        if (factor >> n & 1) wide ^= square << n;
      for (int n = 61; n >= 31; --n)
        if (wide >> n & 1) wide ^= (u64)1 << n | (u64)9 << (n - 31);
      if (odd) result = wide;
      else square = wide;
    }
  }
  return (uint32_t)result;
}

static uint32_t step8(uint32_t r) { return r >> 8 | ((r ^ r >> 3) & 255) << 23; }

Noise noise_at(i64 seed, u64 offset) {
  uint32_t terms = power_of_x(offset);
  u64 ahead = (u64)seed; /* bits 0 to 62 of the stream */
  for (int n = 31; n < 63; ++n) ahead |= ((ahead >> (n - 31) ^ ahead >> (n - 28)) & 1) << n;
  uint32_t state = 0;
  for (int i = 0; i < 31; ++i)
    if (terms >> i & 1) state ^= (uint32_t)(ahead >> i) & 0x7fffffff;
  return (Noise){state};
}

int noise_byte(Noise *n) {
  int byte = n->bits & 255;
  n->bits = step8(n->bits);
  return byte;
}

int bytes_a_word(const Settings *s) {
  static const int bytes[] = {0, 1, 2, 4, 12};
  return bytes[s->dither];
}

i64 amplitude(int bytes, i64 size, int fraction_bits) {
  return half_up(size * power(fraction_bits + 16), (i128)256 * 512 * bytes);
}

void dither_pair(Noise *n, int bytes, i64 scale, i64 d[2]) {
  for (int k = 0; k < 2; ++k) {
    i64 sum = 0;
    for (int byte = 0; byte < bytes; ++byte) sum += noise_byte(n);
    d[k] = (i64)down((i128)(2 * sum - 255 * bytes) * scale, 16, HALF_UP);
  }
}

void dither_words(const Settings *s, int32_t *words) {
  int bytes = bytes_a_word(s);
  Noise n = noise_at(s->dither_seed, 0);
  if (!bytes) return; /* they are 0 */
  i64 scale = amplitude(bytes, s->dither_size, (int)s->fraction_bits), d[2];
  for (i64 pixel = 0; pixel < s->pixels; ++pixel) {
    dither_pair(&n, bytes, scale, d);
    words[2 * pixel] = (int32_t)d[0];
    words[2 * pixel + 1] = (int32_t)d[1];
  }
}

void tap_bytes(i64 seed, i64 taps, i64 pixel, int bytes[25][2]) {
  Noise n = noise_at(seed, (1u << 30) + (u64)(16 * taps * taps * pixel));
  for (int tap = 0; tap < taps * taps; ++tap)
    for (int k = 0; k < 2; ++k) bytes[tap][k] = noise_byte(&n);
}
