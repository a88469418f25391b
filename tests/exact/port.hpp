// What the program of tools/exact asks of the place where it runs; one port_*.cpp for each kind.
#pragma once

#include <cstddef>
#include <cstdint>

namespace umbra78::exact::port {

void write(const char* text, std::size_t size);

// Instructions so far; always 0 where they are not counted.
std::uint64_t instructions();

// Shows a plane of side x side bytes, where there is something to show it on.
void show(const std::uint8_t* plane, int side);

}  // namespace umbra78::exact::port

// The program, whose memory holds `filler` in every byte before a frame. It draws the cases whose
// names begin with `only` ("figures": 1 to 6). 0 if all has been drawn.
int umbra78_exact(int filler, const char* only = "");
