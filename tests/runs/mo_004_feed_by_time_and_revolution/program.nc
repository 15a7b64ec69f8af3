N10 G360 G01 X100 F6000
N20 G93 F2 X200 ; 100 mm in 2 s
N30 G94 X300 ; the F of N10 is back
N40 M3 S1200
N50 G04 X0.5 ; the spindle turns
N60 G95 F1.5 X330 ; 1.5 mm in a revolution
N70 S2400 X360 ; the feed grows with the spindle's speed
M30
