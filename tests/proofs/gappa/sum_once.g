# stage: sum_once
# what: hw/transform_unit: four exact products, summed and rounded once, half up
# bound: 0.5
# unit: LSB of a result, 2^14 of the accumulator
@half_up = fixed<0,nu>;
sum = p0 + p1 + p2 + p3;
out = half_up(sum * 1b-14);
# weaken: [-0.5, 0.5] => [-0.49, 0.5]
{ out - sum * 1b-14 in [-0.5, 0.5] }
