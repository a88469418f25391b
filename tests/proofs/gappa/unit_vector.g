# stage: unit_vector
# what: raster/shading, unit_vector: v 2^14 / floor |v|, the length at least 2^29
# unit: 2^-14
# bound: 0.50004
@floor = fixed<0,dn>;
@half_up = fixed<0,nu>;
L = floor(l);
out = half_up(x / L * 16384);
# weaken: [0, 0.50004] => [0, 0.50002]
{ l in [536870912, 1b31] /\ L in [536870912, 1b31] /\ |x / L| in [0, 1] ->
  |out - x / l * 16384| in [0, 0.50004] }
out - x / l * 16384 -> (out - x / L * 16384) - ((x / l) - (x / L)) * 16384;
(x / l) - (x / L) -> ((x - x) - (x / L) * (l - L)) / l { l <> 0, L <> 0 };
