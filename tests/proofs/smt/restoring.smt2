; hw/clocked/divider.hpp: the restoring divider, by induction over its steps.
;
; After k steps the quotient's bits so far are Q, the remainder is r and the bits of the dividend
; that were read make N. The product Q d is named P, so that a step is linear:
;
;   invariant   N = P + r,  0 <= r < d
;   step        N' = 2 N + bit,  Q' = 2 Q + one,  P' = 2 P + one d
;
; compare: quotient_bit next_remainder dividend_bit
;
; What is read: bit i of |acc| 2^(shift + 1), with at = i - shift - 1 the word's bit.
(set-logic QF_BV)
(define-fun shifted_in ((r (_ BitVec 64)) (bit (_ BitVec 64))) (_ BitVec 64)
  (bvor (bvshl r #x0000000000000001) bit))
(define-fun quotient_bit ((r (_ BitVec 64)) (bit (_ BitVec 64)) (d (_ BitVec 64)))
                         (_ BitVec 64)
  (ite (bvuge (shifted_in r bit) d) #x0000000000000001 #x0000000000000000))
(define-fun next_remainder ((r (_ BitVec 64)) (bit (_ BitVec 64)) (d (_ BitVec 64)))
                           (_ BitVec 64)
  (ite (= (quotient_bit r bit d) #x0000000000000001) (bvsub (shifted_in r bit) d)
       (shifted_in r bit)))
(define-fun dividend_bit ((magnitude (_ BitVec 64)) (at (_ BitVec 64))) (_ BitVec 64)
  (ite (or (bvslt at #x0000000000000000) (bvsgt at #x000000000000003f)) #x0000000000000000
       (bvand (bvlshr magnitude at) #x0000000000000001)))
(declare-const r (_ BitVec 64))
(declare-const bit (_ BitVec 64))
(declare-const d (_ BitVec 64))
(declare-const N (_ BitVec 192))
(declare-const P (_ BitVec 192))
(define-fun wide ((x (_ BitVec 64))) (_ BitVec 192) ((_ zero_extend 128) x))
(define-fun twice ((x (_ BitVec 192))) (_ BitVec 192) (bvshl x (_ bv1 192)))
; claim: base: with Q = P = 0 and r = N, less than d, the invariant holds
; weaken: (= N (wide r)) (bvult r d) => (= N (wide r)) (bvule r d)
(push)
(assert (and (= P (_ bv0 192)) (= N (wide r)) (bvult r d)))
(assert (not (and (= N (bvadd P (wide r))) (bvult r d))))
(check-sat)
(pop)
; claim: step: the invariant is kept for every divisor of 63 bits, and no bit of r is lost
; weaken: (bvule d #x7fffffffffffffff) => (bvule d #xffffffffffffffff)
(push)
(assert (and (bvugt d #x0000000000000000) (bvule d #x7fffffffffffffff)))
(assert (bvule bit #x0000000000000001))
(assert (and (= N (bvadd P (wide r))) (bvult r d) (bvult N (bvshl (_ bv1 192) (_ bv128 192)))))
(assert (bvule P N))
(assert (let ((one (quotient_bit r bit d)) (s (next_remainder r bit d)))
          (let ((P2 (bvadd (twice P) (ite (= one #x0000000000000001) (wide d) (_ bv0 192))))
                (N2 (bvadd (twice N) (wide bit))))
            (not (and (= N2 (bvadd P2 (wide s))) (bvult s d) (bvule P2 N2))))))
(check-sat)
(pop)
; claim: the bits that are read are those of |acc| 2^(shift + 1), from the top: what was read above
; bit i, doubled, and bit i are what was read above bit i - 1; for at from -126 to 63
; weaken: (bvsgt at #x000000000000003f) => (bvsgt at #x000000000000003e)
(push)
(declare-const magnitude (_ BitVec 64))
(declare-const at (_ BitVec 64))
(assert (and (bvsge at #xffffffffffffff82) (bvsle at #x000000000000003f)))
(define-fun read_above ((k (_ BitVec 64))) (_ BitVec 192)
  (ite (bvslt k #x0000000000000000) (bvshl (wide magnitude) (wide (bvneg k)))
       (bvlshr (wide magnitude) (wide k))))
(assert (not (= (read_above at)
                (bvadd (twice (read_above (bvadd at #x0000000000000001)))
                       (wide (dividend_bit magnitude at))))))
(check-sat)
(pop)
