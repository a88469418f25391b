# fault: plain char with a sign
# in: shadow/filters/dequantize.cpp
# by: target s390x g++ -O1: figures
s/static_cast<std::int16_t>\(up \? 1 : -1\)/static_cast<char>(up ? 1 : -1)/
