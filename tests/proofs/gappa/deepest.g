# stage: deepest
# what: raster/block: a leaf's corner after 24 splits each way in any order, and 8 halvings
# unit: raster unit
# why: each of 56 halvings is taken at its worst; corrections of 0 stay 0, and curves flatten
# bound: {deepest()}
# halving_step.smt2 adds up what a halving adds; here that it is less than 1/64 pixel.
# weaken: [0, 128] => [0, 100]
{ e in [0, {deepest()}] -> e in [0, 128] }
