# stage: ramp_{k}
# what: shadow/filters/ramp: 255 (1 - distance / {k}), the distance floored to 1/256 pixel
# each: k 2 .. 32
# unit: level of 255
# why: the stage has finitely many inputs, and all were tried: what was found is its exact bound
# bound: {0.500000001 + 255 / (256 * k)}
@floor8 = fixed<-8,dn>;
@half_up = fixed<0,nu>;
D = floor8(d);
out = half_up(255 - D * 255 / {k});
# weaken: fixed<-8,dn> => fixed<-7,dn>
{ out - (255 - d * 255 / {k}) in [-0.5, {0.500000001 + 255 / (256 * k)}] }
out - (255 - d * 255 / {k}) -> (out - (255 - D * 255 / {k})) - (D - d) * 255 / {k};
