# stage: edge_crossing
# what: shadow/filters/dequantize: an edge's crossing, floored to 2^-12 pixel, then to 1/16 half up
# unit: 1/16 pixel
# bound: 0.5
# A half up of a number with 8 fraction bits is 127/256 too small at most (words.txt, edge_step_32).
@floor12 = fixed<-8,dn>;
@half_up = fixed<0,nu>;
at = floor12(x);
step = half_up(at);
# weaken: [-0.5, 0.5] => [-0.49, 0.5]
{ step - at in [-0.49609375, 0.5] -> step - x in [-0.5, 0.5] }
step - x -> (step - at) + (at - x);
