; fixed/rounding.hpp: round_shift and scale_shift round as their table says, for every 64-bit v and
; every shift, and no step leaves 64 bits. The specification is of e = result 2^n - v in 144 bits.
; Modes are numbered as fixed::Rounding.
; compare: rounds_up round_shift far_shift
(set-logic QF_BV)
(define-fun rounds_up ((negative Bool) (odd Bool) (twice (_ BitVec 64)) (divisor (_ BitVec 64))
                       (mode (_ BitVec 3))) Bool
  (let ((never #xffffffffffffffff) (one #x0000000000000001) (zero #x0000000000000000))
    (bvugt twice
      (ite (= mode #b000) never
      (ite (= mode #b001) zero
      (ite (= mode #b010) (ite negative zero never)
      (ite (= mode #b011) (bvsub divisor one)
      (ite (= mode #b100) (bvsub divisor (ite negative one zero))
      (ite (= mode #b101) (bvsub divisor (ite negative zero one))
                          (bvsub divisor (ite odd one zero)))))))))))
(define-fun round_shift ((v (_ BitVec 64)) (n (_ BitVec 64)) (mode (_ BitVec 3))) (_ BitVec 64)
  (let ((divisor (bvshl #x0000000000000001 n)) (floor (bvashr v n)))
    (let ((remainder (bvand v (bvsub divisor #x0000000000000001))))
      (bvadd floor
        (ite (rounds_up (bvslt v #x0000000000000000) (= ((_ extract 0 0) floor) #b1)
                        (bvadd remainder remainder) divisor mode)
             #x0000000000000001 #x0000000000000000)))))
; The branch of scale_shift for n > 62.
(define-fun far_shift ((v (_ BitVec 64)) (n (_ BitVec 64)) (mode (_ BitVec 3))) (_ BitVec 64)
  (let ((first (ite (bvult n #x0000000000000041) (bvsub n #x000000000000003e)
                    #x0000000000000003)))
    (let ((lost (bvand v (bvsub (bvshl #x0000000000000001 first) #x0000000000000001))))
      (round_shift (bvor (bvashr v first)
                         (ite (= lost #x0000000000000000) #x0000000000000000
                              #x0000000000000001))
                   #x000000000000003e mode))))
; The specification: e is how far the rounded value lies above the exact one, in 1/unit.
(define-fun is_rounding ((e (_ BitVec 144)) (unit (_ BitVec 144)) (negative Bool) (odd Bool)
                         (mode (_ BitVec 3))) Bool
  (let ((zero (_ bv0 144)) (twice (bvadd e e)) (minus (bvneg unit)))
    (let ((down (and (bvslt minus e) (bvsle e zero))) (up (and (bvsle zero e) (bvslt e unit)))
          (tie_up (and (bvslt minus twice) (bvsle twice unit)))
          (tie_down (and (bvsle minus twice) (bvslt twice unit))))
      (ite (= mode #b000) down
      (ite (= mode #b001) up
      (ite (= mode #b010) (ite negative up down)
      (ite (= mode #b011) tie_up
      (ite (= mode #b100) (ite negative tie_up tie_down)
      (ite (= mode #b101) (ite negative tie_down tie_up)
                          (and (bvsle minus twice) (bvsle twice unit)
                               (=> (or (= twice unit) (= twice minus)) (not odd))))))))))))
(declare-const v (_ BitVec 64))
(declare-const n (_ BitVec 64))
(declare-const mode (_ BitVec 3))
(assert (bvult mode #b111))
(define-fun wide ((x (_ BitVec 64))) (_ BitVec 144) ((_ sign_extend 80) x))
(define-fun error ((result (_ BitVec 64))) (_ BitVec 144)
  (bvsub (bvshl (wide result) (wide n)) (wide v)))
(define-fun holds ((result (_ BitVec 64))) Bool
  (is_rounding (error result) (bvshl (_ bv1 144) (wide n)) (bvslt v #x0000000000000000)
               (= ((_ extract 0 0) result) #b1) mode))
; claim: round_shift, shifts 0 to 62
; weaken: (bvult n #x000000000000003f) => (bvult n #x0000000000000041)
(push)
(assert (bvult n #x000000000000003f))
(assert (not (holds (round_shift v n mode))))
(check-sat)
(pop)
; claim: round_shift rounds up by 1 without leaving 64 bits
; weaken: (= (bvashr v n) #x7fffffffffffffff) => (= (bvashr v n) #x7ffffffffffffffe)
(push)
(assert (bvult n #x000000000000003f))
(assert (= (bvashr v n) #x7fffffffffffffff))
(assert (not (= (round_shift v n mode) #x7fffffffffffffff)))
(check-sat)
(pop)
; claim: scale_shift, shifts 63 to 72; from 65 on its steps do not depend on the shift
; weaken: (bvult n #x0000000000000041) => (bvult n #x0000000000000040)
(push)
(assert (and (bvugt n #x000000000000003e) (bvult n #x0000000000000049)))
(assert (not (holds (far_shift v n mode))))
(check-sat)
(pop)
