# stage: dither
# what: fixed/dither, dither_word: noise times an amplitude with 16 fraction bits, rounded once
# unit: LSB of X
# bound: 0.5
@half_up = fixed<0,nu>;
out = half_up(noise * amplitude * 1b-17);
# weaken: [0, 0.5] => [0, 0.49]
{ |out - noise * amplitude * 1b-17| in [0, 0.5] }
