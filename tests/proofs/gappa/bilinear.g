# stage: bilinear
# what: shadow/light_place, blend_of: the blend of four codes at the scale 2^(2 F), of words alone
# unit: 2^-14 quantum
# bound: 0
@word = fixed<0,dn>;
upper = word((128 - fx) * a + fx * b);
lower = word((128 - fx) * c + fx * d);
out = word((128 - fy) * upper + fy * lower);
exact = (128 - fy) * ((128 - fx) * a + fx * b) + fy * ((128 - fx) * c + fx * d);
# weaken: @FIX(fy, 0) => @FIX(fy, -1)
{ @FIX(fx, 0) /\ @FIX(fy, 0) /\ @FIX(a, 0) /\ @FIX(b, 0) /\ @FIX(c, 0) /\ @FIX(d, 0) ->
  out - ((128 - fy) * upper + fy * lower) in [0, 0] /\
  upper - ((128 - fx) * a + fx * b) in [0, 0] /\ lower - ((128 - fx) * c + fx * d) in [0, 0] }
