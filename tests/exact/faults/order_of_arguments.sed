# fault: order of arguments
# in: hw/noise_source.hpp
# by: target x86-64 clang++ locals 0xaa: figures
s/const int sx = sum\(\);\n +const int sy = sum\(\);\n[^;]*;/return words(sum(), sum());/
s/private:\n    int sum\(\)/private:\
    DitherWords words(int sy, int sx) const {\
        return {fixed::dither_word(sx, k_, amplitude_), fixed::dither_word(sy, k_, amplitude_)};\
    }\
    int sum()/
