# stage: halving_{k}
# what: raster/block, leaf_grid: a leaf's corner after {k} of eight halvings, in u and then in v
# each: k 1 .. 8
# unit: raster unit
# bound: {max(leaf(k)[1], -leaf(k)[0])}
# why: the bound takes the worst of all roundings at once; a curve has four words for them
# Of a midpoint's ends one was made by the halving before, the other earlier. Half up of a half
# raises by a half or not at all (words.txt, halve_32).
F = mid;
f = (f0 + f1 - (g0 + g1)) * 0.5;
# weaken: F0 - f0 in [{leaf(k - 1)[0]}, => F0 - f0 in [{leaf(k - 1)[0]}3,
{ F - (F0 + F1 - (G0 + G1)) * 0.5 in [0, 0.5] /\
  F0 - f0 in [{leaf(k - 1)[0]}, {leaf(k - 1)[1]}] /\
  F1 - f1 in [{leaf(k - 1)[2]}, {leaf(k - 1)[3]}] /\
  G0 - g0 in [{leaf(k - 1)[4]}, {leaf(k - 1)[5]}] /\
  G1 - g1 in [{leaf(k - 1)[4]}, {leaf(k - 1)[5]}] ->
  F - f in [{leaf(k)[0]}, {leaf(k)[1]}] }
F - f -> (F - (F0 + F1 - (G0 + G1)) * 0.5) +
         ((F0 - f0) + (F1 - f1) - ((G0 - g0) + (G1 - g1))) * 0.5;
