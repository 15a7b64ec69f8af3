; MOS functions and a motion: one tick for all of them
M100
M101
N10 G00 X1

; all of this is taken in one tick, too
G90 G71
V.E.VALUE = 5
#RT CYCLE DEF [ID = 1 SCOPE = PROG]
  V.E.VALUE1 = V.E.VALUE
#RT CYCLE END
#RT CYCLE START [ID = 1]
G00 X1
G00 X1 Y0 Z0
F500
V.E.VALUE = 6
N20 G00 X3
M30
