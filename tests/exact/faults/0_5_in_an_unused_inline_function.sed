# fault: 0.5 in an unused inline function
# in: fixed/rounding.hpp
# by: guard literals
s/(\n\}  \/\/ namespace umbra78::fixed)/\
inline int half_of(int v) { return static_cast<int>(.5 * v); }\
\1/
