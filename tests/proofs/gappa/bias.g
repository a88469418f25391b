# stage: bias
# what: hw/matrix_rows: translation and bias of row Z, a word times one_word, at exponent 0
# unit: quantum
# bound: 1
@word = fixed<0,ne>;
@half_up = fixed<0,nu>;
out = half_up((rest + word(t) * 16384) * 1b-14);
# weaken: [0, 1] => [0, 0.99]
{ @FIX(rest, 0) -> |out - (rest + t * 16384) * 1b-14| in [0, 1] }
out - (rest + t * 16384) * 1b-14 ->
  (out - (rest + word(t) * 16384) * 1b-14) + (word(t) - t);
