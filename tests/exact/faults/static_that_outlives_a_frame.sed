# fault: static that outlives a frame
# in: hw/noise_source.hpp
# by: guard objects
s/int total = 0;/static int drawn = 0;\
        int total = drawn++ < 0 ? 1 : 0;/
