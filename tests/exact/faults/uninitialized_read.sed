# fault: uninitialized read
# in: hw/noise_source.hpp
# by: target x86-64 clang++ locals 0xaa: figures
s/int total = 0;/int total;/
