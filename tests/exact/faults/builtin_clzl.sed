# fault: __builtin_clzl
# in: fixed/root.hpp
# by: target x86-32 g++ -O1: figures
s/std::countl_zero\(v\) \/ 2/__builtin_clzl(v) \/ 2/
