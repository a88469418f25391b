; compare: too_great
; fixed/wide_product.hpp: divide_wide, 128 bits by 64, from two 32-bit digits (Knuth, TAOCP 4.3.1,
; algorithm D). Products with the digit are named: A = digit d1, B = digit d0; so a step of the
; digit's correction is linear. What is used of a product is proved first, over the reals.
(set-logic ALL)
(define-fun two32 () Int 4294967296)
; The digit's estimate is too great while this holds.
(define-fun too_great ((rest Int) (next Int) (B Int)) Bool
  (and (< rest 4294967296) (> B (+ (* rest 4294967296) next))))
(declare-const upper Int)
(declare-const next Int)
(declare-const d1 Int)
(declare-const d0 Int)
(declare-const digit Int)
(declare-const rest Int)
(declare-const A Int)
(declare-const B Int)
(define-fun d () Int (+ (* two32 d1) d0))
(assert (and (<= 2147483648 d1) (< d1 two32) (<= 0 d0) (< d0 two32)))
(assert (and (<= 0 upper) (< upper d) (<= 0 next) (< next two32)))
; remainder of upper 2^32 + next after taking digit d
(define-fun remainder () Int (- (+ (* two32 upper) next) (+ (* two32 A) B)))
; What products satisfy: A = digit d1 >= digit 2^31, B = digit d0 <= digit (2^32 - 1).
(define-fun products ((q Int) (a Int) (b Int)) Bool
  (and (<= 0 q) (<= (* q 2147483648) a) (<= 0 b) (<= b (* q (- two32 1)))))
(define-fun invariant ((q Int) (r Int) (a Int) (b Int)) Bool
  (and (products q a b) (= (+ a r) upper) (<= 0 r) (< (- (+ (* two32 upper) next)
       (+ (* two32 a) b)) d)))
; claim: base: digit = upper / d1 and rest = upper % d1 satisfy the invariant
; weaken: (< rest d1) => (< rest (* 2 d1))
(push)
(assert (and (products digit A B) (= (+ A rest) upper) (<= 0 rest) (< rest d1)))
(assert (not (invariant digit rest A B)))
(check-sat)
(pop)
; claim: step: a digit that is too great is at least 1, and one less keeps the invariant; rest is
; below 2^33, so it does not leave 64 bits
; weaken: (too_great rest next B) => (< rest two32)
(push)
(assert (and (invariant digit rest A B) (too_great rest next B)))
(assert (products (- digit 1) (- A d1) (- B d0)))
(assert (not (and (>= digit 1) (< (+ rest d1) (* 2 two32))
                  (invariant (- digit 1) (+ rest d1) (- A d1) (- B d0)))))
(check-sat)
(pop)
; claim: end: a digit that is not too great is the quotient, 0 <= remainder < d and digit < 2^32
; weaken: (not (too_great rest next B)) => (>= digit 0)
(push)
(assert (and (invariant digit rest A B) (not (too_great rest next B))))
; digit <= upper / d1, and upper < (d1 + 1) 2^32: the estimate is at most 2^32 + 1
(assert (<= digit (+ two32 1)))
(assert (=> (>= digit two32) (and (>= A (* two32 d1)) (>= B (* two32 d0)))))
(assert (not (and (<= 0 remainder) (< remainder d) (< digit two32))))
(check-sat)
(pop)
; claim: the estimate is at most 2^32 + 1, so digit d0 stays within 64 bits
; weaken: (+ two32 2) => (+ two32 1)
(push)
(assert (and (= (+ A rest) upper) (<= 0 rest) (< rest d1) (>= digit (+ two32 2))))
(assert (>= A (* (+ two32 2) d1)))  ; as A = digit d1
(check-sat)
(pop)
; claim: (2^32 + 1)(2^32 - 1) < 2^64
; weaken: (* (+ two32 1) (- two32 1)) => (* (+ two32 1) two32)
(push)
(assert (not (< (* (+ two32 1) (- two32 1)) (* two32 two32))))
(check-sat)
(pop)
; claim: two digits make the quotient of 96 bits and more: numerator = (q1 2^32 + q2) d + r2
; weaken: (* l1 two32) l0) => (* l1 two32))
(push)
(declare-const l1 Int)
(declare-const l0 Int)
(declare-const q1 Int)
(declare-const q2 Int)
(declare-const P1 Int)
(declare-const P2 Int)
(declare-const r1 Int)
(declare-const r2 Int)
(assert (= (+ (* upper two32) l1) (+ P1 r1)))
(assert (= (+ (* r1 two32) l0) (+ P2 r2)))
(assert (not (= (+ (* upper two32 two32) (* l1 two32) l0) (+ (* P1 two32) P2 r2))))
(check-sat)
(pop)
; claim: a product grows with its factor: x >= c, y >= 0 give x y >= c y
; weaken: (>= y 0.0) => (>= y (- 1.0))
(push)
(declare-const x Real)
(declare-const y Real)
(declare-const c Real)
(assert (and (>= x c) (>= y 0.0)))
(assert (not (>= (* x y) (* c y))))
(check-sat)
(pop)
