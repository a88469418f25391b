# stage: highlight_{k}
# what: raster/shading, highlight: square {k} of a cosine of 14 bits, rounded half up
# each: k 1 .. 9
# unit: 2^-14
# why: all 16385 cosines were tried: what was found is the exact bound; near 1 squares round less
# bound: {squares(k)}
@half_up = fixed<0,nu>;
H1 = half_up(H * H * 1b-14);
# weaken: half_up(H * H * 1b-14) => half_up(H * H * 1b-15)
{ h in [0, 16384] /\ H in [0, 16384] /\ |H - h| in [0, {squares(k - 1)}] ->
  |H1 - h * h * 1b-14| in [0, {squares(k)}] }
H1 - h * h * 1b-14 -> (H1 - H * H * 1b-14) + (H - h) * (H + h) * 1b-14;
