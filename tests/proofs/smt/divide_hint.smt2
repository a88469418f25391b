; The rewriting that gappa/divide_*.g, cosine.g and unit_vector.g give Gappa as a hint, which takes
; it for granted: the difference of two quotients, over the reals.
(set-logic QF_NRA)
(declare-const x Real)
(declare-const w Real)
(declare-const X Real)
(declare-const W Real)
; claim: x / w - X / W = ((x - X) - (X / W) (w - W)) / w for w, W not 0
; weaken: (* (/ X W) (- w W)) => (* (/ X W) (- W w))
(push)
(assert (and (not (= w 0.0)) (not (= W 0.0))))
(assert (not (= (- (/ x w) (/ X W)) (/ (- (- x X) (* (/ X W) (- w W))) w))))
(check-sat)
(pop)
