# stage: correction
# what: raster/block: a correction after any number of halvings: an eighth of a sum, or a quarter
# unit: raster unit
# bound: 0.66666667
@half_up = fixed<0,nu>;
M = half_up((G0 + G1) * 0.125);
m = (g0 + g1) * 0.125;
E = half_up(G0 * 0.25);
e = g0 * 0.25;
# weaken: |G0 - g0| in [0, 0.66666667] => |G0 - g0| in [0, 0.7]
{ |G0 - g0| in [0, 0.66666667] /\ |G1 - g1| in [0, 0.66666667] ->
  |M - m| in [0, 0.66666667] /\ |E - e| in [0, 0.66666667] }
M - m -> (M - (G0 + G1) * 0.125) + ((G0 - g0) + (G1 - g1)) * 0.125;
E - e -> (E - G0 * 0.25) + (G0 - g0) * 0.25;
