# fault: __int128
# in: shadow/filters/dequantize.cpp
# by: target x86-32 g++ -O1: figures
s/const std::int64_t along = /const __int128 along = /
