%probing
; Probes the edge of a workpiece twice, fast and slowly, and makes it X0 (the probe's ball: 2 mm)
; given: plc workpiece.py
N10 G00 X10 Y10 Z5
N20 G01 Z-5 F3000
N30 #MEAS [ERR_NO_SIGNAL=1]
N40 G100 X60 F1200
N50 V.P.FAST = V.A.MESS.X
N60 G00 X[V.P.FAST - 2]
N70 G100 X60 F120
N80 #MSG ["fast %.3f, slow %.3f", V.P.FAST, V.A.MESS.X]  ; expect: message "fast 40.310, slow 40.302"
N90 V.P.EDGE = V.A.MESS.X + 2
N100 G00 X20
N110 G92 X[V.P.EDGE]
N120 G00 X-8 Y-10
N130 G01 Y50 F3000          ; along the edge, 8 mm beside it
N140 #MSG ["along X%.3f", V.A.ABS.X]
N150 G00 Z20                ; expect: ended
M30
