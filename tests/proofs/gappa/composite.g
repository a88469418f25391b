# stage: composite
# what: shadow/filters/composite: a share of the picture taken away, rounded once
# unit: level of 255
# bound: 0.5
@half_up = fixed<0,nu>;
out = half_up(level - share * mask * density / 65280);
# weaken: [0, 0.5] => [0, 0.49]
{ |out - (level - share * mask * density / 65280)| in [0, 0.5] }
