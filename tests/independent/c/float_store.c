/* Section 28: the codes that a depth store of floats keeps, and the floats' bits. */
#include "machine.h"

/* What the store's float stands for, in units of 2^-z_bits: the code, or what it lacks of 1. */
static i64 stored(i64 code, const Settings *s) {
  return s->depth_store == FLOAT_REVERSED ? ((i64)1 << s->z_bits) - code : code;
}

/* Of a code 0 .. deepest_drawn. */
i64 kept_code(i64 code, const Settings *s) {
  if (s->depth_store == FIXED_STORE) return code;
  int n = (int)s->z_bits, drop = (int)greater(0, bits((u128)stored(code, s)) - 24);
  i64 r = (i64)(down(stored(code, s), drop, HALF_EVEN) * power(drop));
  i64 limit = (i64)(power(n) - power((int)greater(1, n - 24)));
  if (s->depth_store == FLOAT_REVERSED) return (i64)power(n) - r;
  return r < limit ? r : limit;
}

i64 float_bits(i64 kept, const Settings *s) {
  i64 v = stored(kept, s);
  int length = bits((u128)v);
  if (v == 0) return 0;
  return (i64)((125 + length - s->z_bits) * power(23) + down(v, length - 24, FLOOR));
}
