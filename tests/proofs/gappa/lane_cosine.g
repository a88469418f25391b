# stage: lane_cosine
# what: raster/shade_body: a cosine by the reciprocal root is within one of the quotient's floor
# unit: 2^-14
# seen: tests
# bound: 1.5
# high: the dot product less its low 8 bits, Y: the reciprocal length of 30 fraction bits, of 2^24,
# which three of Newton's steps leave within 2^-27 (forms: every argument of the root is tried)
@floor = fixed<0,dn>;
@floor8 = fixed<8,dn>;
high = floor8(dot) * 1b-8;
quotient = floor(high * Y * 1b-46);
exact = dot * y * 1b-54;
# weaken: [-1b-27, 1b-27] => [-1b-14, 1b-14]
{ |dot| in [0, 1b40] /\ y in [1b29, 1b31] /\ Y -/ y in [-1b-27, 1b-27] /\
  |dot * y * 1b-54| in [0, 16400] -> |quotient - exact| in [0, 1.5] }
quotient - exact -> (quotient - high * Y * 1b-46) + (high * Y * 1b-46 - exact);
high * Y * 1b-46 - exact ->
  (floor8(dot) - dot) * Y * 1b-54 + dot * y * 1b-54 * ((Y - y) / y) { y <> 0 };
