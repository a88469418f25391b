# stage: low_pass
# what: shadow/filters/low_pass: the weighted sum of nine, rounded once
# unit: level of 255
# bound: 0.5
@half_up = fixed<0,nu>;
out = half_up(sum * 1b-4);
# weaken: [0, 0.5] => [0, 0.49]
{ |out - sum * 1b-4| in [0, 0.5] }
