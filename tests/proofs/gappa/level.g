# stage: level
# what: raster/shading, level: a sum with 30 fraction bits to a level, rounded once
# unit: level of 255
# bound: 0.5
@half_up = fixed<0,nu>;
out = half_up(sum * 1b-30);
# weaken: [0, 0.5] => [0, 0.49]
{ |out - sum * 1b-30| in [0, 0.5] }
