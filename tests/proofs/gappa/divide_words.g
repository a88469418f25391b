# stage: divide_words_{j}
# what: hw/transform_unit: rounded coefficients, one quotient; acc of W in octave {j}
# each: j 24 .. 31
# unit: LSB of X, 2^-7 pixel
# bound: {0.5 + 57344 * (128 + 2 ** 16) / 2 ** j}
@half_up = fixed<0,nu>;
q = half_up(X / W * 128);
# X, W are sums of words, x, w those of the exact matrix: half a coefficient times each word
# weaken: |X - x| in [0, 57344] => |X - x| in [0, 57444]
{ w in [{2 ** j}, {2 ** (j + 1)}] /\ W in [1, 1b40] /\ |X / W| in [0, 512] /\
  |X - x| in [0, 57344] /\ |W - w| in [0, 57344] ->
  |q - x / w * 128| in [0, {0.5 + 57344 * (128 + 2 ** 16) / 2 ** j}] }
q - x / w * 128 -> (q - X / W * 128) - ((x / w) - (X / W)) * 128;
(x / w) - (X / W) -> ((x - X) - (X / W) * (w - W)) / w {{ w <> 0, W <> 0 }};
