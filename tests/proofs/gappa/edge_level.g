# stage: edge_level
# what: shadow/filters/dequantize: a pixel's area, of 256, as a level, rounded half up
# unit: level of 255
# bound: 0.5
@half_up = fixed<0,nu>;
out = half_up(area * 255 / 256);
# weaken: [0, 0.5] => [0, 0.49]
{ |out - area * 255 / 256| in [0, 0.5] }
