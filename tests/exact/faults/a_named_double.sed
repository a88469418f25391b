# fault: a named double
# in: fixed/rounding.hpp
# by: guard tokens
s/(\n\}  \/\/ namespace umbra78::fixed)/\
inline int half_of(int v) {\
    const double half = v;\
    return static_cast<int>(half) \/ 2;\
}\
\1/
