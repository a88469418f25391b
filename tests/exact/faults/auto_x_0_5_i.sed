# fault: auto x = 0.5 * i
# in: shadow/filters/edge_nodes.hpp
# by: guard literals
s/(along = )row \* sub_row \+ sub_row \/ 2/\1static_cast<int>((row + 0.5) * sub_row)/
