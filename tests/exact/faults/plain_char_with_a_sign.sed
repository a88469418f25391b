# fault: plain char with a sign
# in: shadow/filters/edge_nodes.hpp
# by: target s390x g++ -O1: figures
s/up \? crossed.sixteenths : -crossed.sixteenths/static_cast<char>(up ? 1 : -1) * crossed.sixteenths/
