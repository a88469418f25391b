# stage: sum_cut_near
# what: hw/transform_unit: each product rounded half up to a 22-bit accumulator
# unit: LSB of a result, 2^14 of the accumulator
# bound: 1.25
# Beside sum_once: per-product rounding to nearest against one rounding. As sum_cut.g.
@cut = fixed<13,nu>;
sum = p0 + p1 + p2 + p3;
acc = cut(p0) + cut(p1) + cut(p2) + cut(p3);
# weaken: [-0.75, 1.25] => [-0.7, 1.25]
{ @FIX(p3, 14) /\ out - acc * 1b-14 in [0, 0.5] -> out - sum * 1b-14 in [-0.75, 1.25] }
out - sum * 1b-14 -> (out - acc * 1b-14) + (acc - sum) * 1b-14;
