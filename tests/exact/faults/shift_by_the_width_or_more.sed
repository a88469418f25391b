# fault: shift by the width or more
# in: shadow/filters/dequantize.cpp
# by: target s390x g++ -O1: figures
s/>> \(at\(x, y\) % 32\) & 1u/>> at(x, y) \& 1u/
s/1u << \(at\(x, y\) % 32\)/1u << at(x, y)/
