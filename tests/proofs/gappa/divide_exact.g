# stage: divide_exact
# what: fixed/divide, hw/transform_unit: the quotient of exact accumulators, rounded once
# unit: LSB of X
# bound: 0.5
@half_up = fixed<0,nu>;
q = half_up(x / w * 128);
# weaken: [0, 0.5] => [0, 0.499]
{ |q - x / w * 128| in [0, 0.5] }
