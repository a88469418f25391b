# stage: array_row
# what: hw/ap120b/transform: a row of products and sums, each rounded to 27 bits, of 16-bit words
# unit: LSB of a host's word
# bound: {13 * 2.0 ** -13}
# Coefficients are floats within 1; the fourth product, by 1, is exact.
@word = float<27,-539,ne>;
p0 = word(m0 * x); p1 = word(m1 * y); p2 = word(m2 * z);
s1 = word(p0 + p1); s2 = word(s1 + p2); out = word(s2 + m3);
exact = m0 * x + m1 * y + m2 * z + m3;
# weaken: |x| in [0, 32768] => |x| in [0, 65536]
{ |m0| in [0, 1] /\ |m1| in [0, 1] /\ |m2| in [0, 1] /\ |m3| in [0, 1] /\
  |x| in [0, 32768] /\ |y| in [0, 32768] /\ |z| in [0, 32768] ->
  |out - exact| in [0, {13 * 2.0 ** -13}] }
out - exact -> (out - (s2 + m3)) + (s2 - (s1 + p2)) + (s1 - (p0 + p1)) + (p0 - m0 * x)
  + (p1 - m1 * y) + (p2 - m2 * z);
