; shadow/post_process_rows.cpp and row_body.hpp: what a scan line's lanes compute in 32 bits is the
; unit's result, floor(sum / 2^S), at the real widths.
(set-logic QF_BV)
; compare: row_high row_low split_result whole_place
(define-fun row_high ((v (_ BitVec 64)) (s (_ BitVec 64))) (_ BitVec 32)
  ((_ extract 31 0) (bvashr v s)))
(define-fun row_low ((v (_ BitVec 64)) (s (_ BitVec 64))) (_ BitVec 32)
  ((_ extract 31 0) (bvand v (bvsub (bvshl #x0000000000000001 s) #x0000000000000001))))
(define-fun split_result ((a (_ BitVec 64)) (b (_ BitVec 64)) (p (_ BitVec 32))
                          (s (_ BitVec 64))) (_ BitVec 32)
  (bvadd (row_high a s) (row_high b s)
         (bvashr (bvadd (row_low a s) (row_low b s) p) ((_ extract 31 0) s))))
; The sum modulo 2^32, counted from the map's corner, shifted without a sign.
(define-fun whole_place ((sum (_ BitVec 64)) (corner (_ BitVec 64)) (s (_ BitVec 64)))
                        (_ BitVec 32)
  (bvlshr ((_ extract 31 0) (bvadd sum (bvshl corner s))) ((_ extract 31 0) s)))
(declare-const s (_ BitVec 64))
(assert (and (bvuge s #x0000000000000006) (bvule s #x000000000000001c)))
(define-fun within ((v (_ BitVec 64)) (most (_ BitVec 64))) Bool
  (and (bvsle (bvneg most) v) (bvsle v most)))
; claim: a column's and a row's share, split at the binary point, and c_z z: shifts of 6 to 28,
; shares within 2^32, a product within 2^30
; weaken: #x000000000000001c => #x000000000000001f
(push)
(declare-const a (_ BitVec 64))
(declare-const b (_ BitVec 64))
(declare-const p (_ BitVec 32))
(assert (and (within a #x0000000100000000) (within b #x0000000100000000)
             (within ((_ sign_extend 32) p) #x0000000040000000)))
(assert (not (= ((_ sign_extend 32) (split_result a b p s))
                (bvashr (bvadd a b ((_ sign_extend 32) p)) s))))
(check-sat)
(pop)
; claim: where |sum| + corner 2^S < 2^32, a place 0 .. 2 corner - 1 inside the map is itself, and
; one outside is no place inside; corners of 8 to 2^15 pixels and fractions
; weaken: #x00000000ffffffff => #x00000001ffffffff
(push)
(declare-const sum (_ BitVec 64))
(declare-const k (_ BitVec 64))
(assert (and (bvuge k #x0000000000000003) (bvule k #x000000000000000f)))
(define-fun corner () (_ BitVec 64) (bvshl #x0000000000000001 k))
(assert (within sum #x00000000ffffffff))
(assert (bvule (bvadd (ite (bvslt sum #x0000000000000000) (bvneg sum) sum) (bvshl corner s))
               #x00000000ffffffff))
(assert (let ((exact (bvadd (bvashr sum s) corner))
              (place ((_ zero_extend 32) (whole_place sum corner s)))
              (side (bvadd corner corner)))
  (not (ite (and (bvsle #x0000000000000000 exact) (bvslt exact side)) (= place exact)
            (bvuge place side)))))
(check-sat)
(pop)
