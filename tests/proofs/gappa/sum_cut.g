# stage: sum_cut
# what: hw/transform_unit: each product floored to a 22-bit accumulator, which lacks 13 bits
# unit: LSB of a result, 2^14 of the accumulator
# bound: 1.5
# The fourth product, of one = 2^14, has nothing to lose. The sum is a multiple of a half, which
# half up raises by a half or not at all (words.txt, halves_64).
@cut = fixed<13,dn>;
@half_up = fixed<0,nu>;
sum = p0 + p1 + p2 + p3;
acc = cut(p0) + cut(p1) + cut(p2) + cut(p3);
out = half_up(acc * 1b-14);
# weaken: [-1.5, 0.5] => [-1.48, 0.5]
{ @FIX(p3, 14) /\ out - acc * 1b-14 in [0, 0.5] -> out - sum * 1b-14 in [-1.5, 0.5] }
out - sum * 1b-14 -> (out - acc * 1b-14) + (acc - sum) * 1b-14;
