# stage: leading
# what: shadow/rivals/light_lines, sign_by_leading: a determinant of nine numbers' leading bits
# unit: 1, of 2^(3 s)
# why: nine minors are not all twice the greatest square at once; of numbers +-2^20 six can be
# bound: {6 * (3 * 2 ** facts["leading_bits"] * (2 ** facts["leading_bits"] + 1) + 1)}
# One of its six products, each of a number's leading bits plus less than 1.
# weaken: dx in [0, 1] => dx in [0, 1.5]
{ |x| in [0, {2 ** facts["leading_bits"]}] /\ |y| in [0, {2 ** facts["leading_bits"]}] /\
  |z| in [0, {2 ** facts["leading_bits"]}] /\ dx in [0, 1] /\ dy in [0, 1] /\ dz in [0, 1] ->
  |(x + dx) * (y + dy) * (z + dz) - x * y * z|
  in [0, {3 * 2 ** facts["leading_bits"] * (2 ** facts["leading_bits"] + 1) + 1}] }
(x + dx) * (y + dy) * (z + dz) - x * y * z ->
  dx * ((y + dy) * (z + dz)) + x * (dy * (z + dz)) + x * y * dz;
