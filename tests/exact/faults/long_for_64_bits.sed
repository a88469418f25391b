# fault: long for 64 bits
# in: hw/transform_unit.hpp
# by: target x86-32 g++ -O1: percentage
s/std::int64_t\{c\[([0-3])\]\}/long{c[\1]}/g
