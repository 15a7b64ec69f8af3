%short_blocks
; A straight way in blocks of 0.1 mm: a decoder without time enough makes it stop and go.
N10 G01 X0 F6000
$FOR P1 = 1, 100, 1
  N20 G01 X[0.1 * P1]
$ENDFOR
M30
