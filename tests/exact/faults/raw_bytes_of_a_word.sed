# fault: raw bytes of a word
# in: hw/noise_source.hpp
# by: target s390x g++ -O1: percentage
s/static_cast<std::uint8_t>\(pair & 255\)/reinterpret_cast<const std::uint8_t*>(\&pair)[0]/
s/static_cast<std::uint8_t>\(pair >> 8\)/reinterpret_cast<const std::uint8_t*>(\&pair)[1]/
