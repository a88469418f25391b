; compare: divide_rounded signed_rounded corrected
; How a quotient is rounded and gets its sign: round_divide (fixed/rounding.hpp), the end of divide
; and its sticky bit (fixed/divide.hpp), and the clocked divider's correction
; (hw/clocked/divider.hpp). In whole numbers of any size. A product of a quotient and its divisor is
; never written: num = t den + left, so what is one more or less than t is linear in den and left.
(set-logic ALL)
(define-fun rounds_up_int ((negative Bool) (odd Bool) (twice Int) (divisor Int) (mode Int)) Bool
  (ite (= mode 0) false
  (ite (= mode 1) (> twice 0)
  (ite (= mode 2) (and negative (> twice 0))
  (ite (= mode 3) (> twice (- divisor 1))
  (ite (= mode 4) (> twice (- divisor (ite negative 1 0)))
  (ite (= mode 5) (> twice (- divisor (ite negative 0 1)))
                  (> twice (- divisor (ite odd 1 0))))))))))
(define-fun absolute ((x Int)) Int (ite (< x 0) (- x) x))
; round_divide, from t = num / den toward zero and left = num % den.
(define-fun divide_below ((num Int) (den Int) (left Int)) Bool
  (and (not (= left 0)) (not (= (< num 0) (< den 0)))))
(define-fun divide_floor ((num Int) (den Int) (t Int) (left Int)) Int
  (- t (ite (divide_below num den left) 1 0)))
(define-fun divide_rounded ((num Int) (den Int) (t Int) (left Int) (mode Int)) Int
  (let ((below (divide_below num den left)) (floor (divide_floor num den t left)))
    (let ((rem (ite below (- (absolute den) (absolute left)) (absolute left))))
      (+ floor (ite (rounds_up_int (not (= (< num 0) (< den 0))) (= (mod floor 2) 1) (* 2 rem)
                                   (absolute den) mode) 1 0)))))
; The end of divide: |num| 2^shift / den = floor + rem / divisor, and its sign.
(define-fun signed_rounded ((negative Bool) (whole Int) (rem Int) (divisor Int) (mode Int)) Int
  (let ((below (and negative (not (= rem 0)))))
    (let ((floor (ite negative (- (- whole) (ite below 1 0)) whole)))
      (+ floor (ite (rounds_up_int negative (= (mod floor 2) 1)
                                   (* 2 (ite below (- divisor rem) rem)) divisor mode) 1 0)))))
; The clocked divider: quotient = floor(2 |q|), and whether anything is left.
(define-fun corrected ((negative Bool) (quotient Int) (rest Bool) (mode Int)) Int
  (let ((quarters (+ (* 2 (mod quotient 2)) (ite rest 1 0))) (whole (div quotient 2)))
    (let ((below (and negative (not (= quarters 0)))))
      (let ((floor (ite negative (- (- whole) (ite below 1 0)) whole)))
        (+ floor (ite (rounds_up_int negative (= (mod floor 2) 1)
                                     (* 2 (ite below (- 4 quarters) quarters)) 4 mode) 1 0))))))
; The specification: the rounded value lies e / unit above the exact one.
(define-fun is_rounding ((e Real) (unit Real) (negative Bool) (odd Bool) (mode Int)) Bool
  (let ((down (and (< (- unit) e) (<= e 0.0))) (up (and (<= 0.0 e) (< e unit)))
        (tie_up (and (< (- unit) (* 2.0 e)) (<= (* 2.0 e) unit)))
        (tie_down (and (<= (- unit) (* 2.0 e)) (< (* 2.0 e) unit))))
    (ite (= mode 0) down
    (ite (= mode 1) up
    (ite (= mode 2) (ite negative up down)
    (ite (= mode 3) tie_up
    (ite (= mode 4) (ite negative tie_up tie_down)
    (ite (= mode 5) (ite negative tie_down tie_up)
         (and (<= (- unit) (* 2.0 e)) (<= (* 2.0 e) unit)
              (=> (or (= (* 2.0 e) unit) (= (* 2.0 e) (- unit))) (not odd)))))))))))
(declare-const mode Int)
(assert (and (<= 0 mode) (<= mode 6)))
; k den, for k = -1, 0 or 1.
(define-fun times ((k Int) (den Int)) Int (ite (= k 1) den (ite (= k 0) 0 (- den))))
; claim: round_divide rounds num / den; e = R den - num = (R - t) den - left, over |den|
; weaken: (not (= left 0)) => true
(push)
(declare-const num Int)
(declare-const den Int)
(declare-const t Int)
(declare-const left Int)
(assert (and (not (= den 0)) (< (absolute left) (absolute den))))
(assert (<= (absolute left) (absolute num)))
(assert (=> (> left 0) (> num 0)))
(assert (=> (< left 0) (< num 0)))
; t is rounded toward zero: it has the sign of num / den, or is 0 and then left = num.
(assert (=> (= t 0) (= left num)))
(assert (let ((R (divide_rounded num den t left mode)))
  (let ((e (- (times (- R t) den) left)))
    (not (and (<= (- 1) (- R t)) (<= (- R t) 1)
              (is_rounding (to_real (ite (< den 0) (- e) e)) (to_real (absolute den))
                           (not (= (< num 0) (< den 0))) (= (mod R 2) 1) mode))))))
(check-sat)
(pop)
; claim: the end of divide rounds sign (whole + rem / divisor)
; weaken: (not (= rem 0)) => true
(push)
(declare-const negative Bool)
(declare-const whole Int)
(declare-const rem Int)
(declare-const divisor Int)
(assert (and (<= 0 whole) (<= 0 rem) (< rem divisor)))
(assert (let ((R (signed_rounded negative whole rem divisor mode)))
  (let ((k (- R (ite negative (- whole) whole))))
    (not (and (<= (- 1) k) (<= k 1)
              (is_rounding (to_real (- (times k divisor) (ite negative (- rem) rem)))
                           (to_real divisor)
                           negative (= (mod R 2) 1) mode))))))
(check-sat)
(pop)
; claim: of what a right shift cuts off one sticky bit is enough: (2 low + sticky) / 2^(down + 1)
; compares with 0 and with a half as (low + part) / 2^down does, 0 <= part < 1, half = 2^(down - 1)
; weaken: (+ (* 2 low) (ite (= part 0.0) 0 1)) => (* 2 low)
(push)
(declare-const low Int)
(declare-const half Int)
(declare-const part Real)
(assert (and (<= 0 low) (< low (* 2 half)) (<= 1 half) (<= 0.0 part) (< part 1.0)))
(assert (let ((exact (+ (to_real low) part)) (kept (+ (* 2 low) (ite (= part 0.0) 0 1))))
  (not (and (= (= exact 0.0) (= kept 0))
            (= (< exact (to_real half)) (< kept (* 2 half)))
            (= (= exact (to_real half)) (= kept (* 2 half)))
            (< kept (* 4 half))))))
(check-sat)
(pop)
; claim: the clocked divider's correction rounds sign (quotient + part) / 2, 0 <= part < 1
; weaken: (> part 0.0) => false
(push)
(declare-const negative Bool)
(declare-const quotient Int)
(declare-const part Real)
(assert (and (<= 0 quotient) (<= 0.0 part) (< part 1.0)))
(assert (let ((R (corrected negative quotient (> part 0.0) mode))
              (twice (+ (to_real quotient) part)))
  (not (is_rounding (- (* 2.0 (to_real R)) (ite negative (- twice) twice)) 2.0 negative
                    (= (mod R 2) 1) mode))))
(check-sat)
(pop)
