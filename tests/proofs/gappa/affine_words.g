# stage: affine_words_{e}
# what: hw/matrix_rows, transform_unit: a row of rounded words, exponent {e}, rounded once
# each: e -4 .. 4
# unit: LSB of X, 2^-7 pixel
# bound: {57344 * 2.0 ** (e - 14) + 0.5}
# c: exact coefficients, C: the words; x, y, z words of 16 bits, one = 2^14
@word = fixed<0,ne>;
@half_up = fixed<0,nu>;
C0 = word(c0); C1 = word(c1); C2 = word(c2); C3 = word(c3);
acc = C0 * x + C1 * y + C2 * z + C3 * 16384;
exact = c0 * x + c1 * y + c2 * z + c3 * 16384;
out = half_up(acc * 1b{e - 14});
# weaken: |x| in [0, 32768] => |x| in [0, 32800]
{ |x| in [0, 32768] /\ |y| in [0, 32768] /\ |z| in [0, 32768] ->
  |out - exact * 1b{e - 14}| in [0, {57344 * 2.0 ** (e - 14) + 0.5}] }
out - exact * 1b{e - 14} -> (out - acc * 1b{e - 14}) + (acc - exact) * 1b{e - 14};
