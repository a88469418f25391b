# fault: __int128
# in: shadow/filters/edge_nodes.hpp
# by: target x86-32 g++ -O1: figures
s/const int along = /const __int128 along = /
