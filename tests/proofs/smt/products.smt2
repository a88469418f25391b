; What words.py uses of a product of two numbers in ranges: its four linear bounds (McCormick 1976).
; And sums of a unit axis and a difference of world words, which no range of each word alone bounds.
(set-logic QF_NRA)
(declare-const x Real)
(declare-const y Real)
(declare-const a Real)
(declare-const b Real)
(declare-const c Real)
(declare-const d Real)
(declare-const u Real)
(declare-const v Real)
; claim: x y >= a y + c x - a c for x = a + u >= a and y = c + v >= c
; weaken: (>= u 0.0) => (>= u (- 1.0))
(push)
(assert (and (>= u 0.0) (>= v 0.0)))
(assert (let ((x (+ a u)) (y (+ c v))) (not (>= (* x y) (- (+ (* a y) (* c x)) (* a c))))))
(check-sat)
(pop)
; claim: x y >= b y + d x - b d for x = b - u <= b and y = d - v <= d
; weaken: (>= v 0.0) => (>= v (- 1.0))
(push)
(assert (and (>= u 0.0) (>= v 0.0)))
(assert (let ((x (- b u)) (y (- d v))) (not (>= (* x y) (- (+ (* b y) (* d x)) (* b d))))))
(check-sat)
(pop)
; claim: x y <= b y + c x - b c for x = b - u <= b and y = c + v >= c, and with both exchanged
; weaken: (>= u 0.0) => (>= u (- 1.0))
(push)
(assert (and (>= u 0.0) (>= v 0.0)))
(assert (let ((x (- b u)) (y (+ c v))) (not (<= (* x y) (- (+ (* b y) (* c x)) (* b c))))))
(check-sat)
(pop)
; claim: raster/view.hpp, along, and shadow/rivals/space.cpp: the sum of an axis Q2.30 of length 1
; (to 2^-20) times differences below 2^32 stays below 2^63; in units of 2^30 and 2^32
; weaken: 1.000001 => 1.4
(push)
(assert (and (>= x 0.0) (>= y 0.0) (>= a 0.0)))
(assert (<= (+ (* x x) (* y y) (* a a)) 1.000001))
(assert (>= (+ x y a) 2.0))
(check-sat)
(pop)
; claim: raster/view.hpp, axes_from_points: u x - v y of two axes Q2.30 of length 1 (to 2^-20) is at
; most 1.000001, so that up's y component has a word
; weaken: (<= (+ (* x x) (* y y)) 1.000001) => (<= (+ (* x x) (* y y)) 1.1)
(push)
(assert (and (<= (+ (* x x) (* y y)) 1.000001) (<= (+ (* u u) (* v v)) 1.000001)))
(assert (and (>= (* (- u x) (- u x)) 0.0) (>= (* (+ v y) (+ v y)) 0.0)))  ; a hint
(assert (> (- (* u x) (* v y)) 1.000001))
(check-sat)
(pop)
