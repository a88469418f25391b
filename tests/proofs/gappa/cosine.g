# stage: cosine
# what: raster/shading, cosines: floor(n . d / floor |n|), corners' normals within 60 degrees
# unit: 2^-14
# bound: 1.00113
# n . d / |n| is within the length of d, 2^14 + 2; |n| is at least 2^24 cos 30, floored
@floor = fixed<0,dn>;
L = floor(l);
out = floor(x / L);
# weaken: [-1.00113, 0.00113] => [-1.0005, 0.0005]
{ l in [14529495, 16780000] /\ L in [14529494, 16780000] /\ |x / L| in [0, 16387] ->
  out - x / l in [-1.00113, 0.00113] }
out - x / l -> (out - x / L) - ((x / l) - (x / L));
(x / l) - (x / L) -> ((x - x) - (x / L) * (l - L)) / l { l <> 0, L <> 0 };
