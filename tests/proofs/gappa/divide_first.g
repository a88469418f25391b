# stage: divide_first_{j}
# what: hw/transform_unit, round_first: X, W, then X / W rounded; W in octave {j}
# each: j 7 .. 20
# unit: LSB of X, 2^-7 pixel
# bound: {0.5 + (64 + 2 ** 15) / (2 ** j + 0.5)}
@half_up = fixed<0,nu>;
X = half_up(x);
W = half_up(w);
q = half_up(X / W * 128);
# weaken: |X / W| in [0, 512] => |X / W| in [0, 514]
{ w in [{2 ** j + 0.5}, {2 ** (j + 1)}] /\ W in [{2 ** j}, {2 ** (j + 1)}] /\
  |X / W| in [0, 512] -> |q - x / w * 128| in [0, {0.5 + (64 + 2 ** 15) / (2 ** j + 0.5)}] }
q - x / w * 128 -> (q - X / W * 128) - ((x / w) - (X / W)) * 128;
(x / w) - (X / W) -> ((x - X) - (X / W) * (w - W)) / w {{ w <> 0, W <> 0 }};
