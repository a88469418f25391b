# fault: auto x = 0.5 * i
# in: shadow/filters/dequantize.cpp
# by: guard literals
s/(along = )first \* sub_row \+ sub_row \/ 2/\1static_cast<int>((first + 0.5) * sub_row)/
