%thread
; A thread of three passes, each faster than the one before, and a hole that is tapped
; Z = 5 is at angle 0 in each pass: the angle is (5 - Z) / 2 revolutions, that of the tap (2 - Z) / 1.5
N10 G18 G00 X22 Z5
N20 M03 S600
N30 G00 X19.4
N40 G33 Z-20 K2             ; expect: Z = -9.02 at 1000 ticks; expect: S.POSITION = 3.6 at 1000 ticks
N50 G00 X22
N60 Z5
N70 M03 S900
N80 G00 X18.9
N90 G33 Z-20 K2             ; expect: Z = -5.15 at 2200 ticks; expect: S.POSITION = 27.0 at 2200 ticks
N100 G00 X22
N110 Z5
N120 M03 S1200
N130 G00 X18.7
N140 G33 Z-20 K2            ; expect: Z = -7.76 at 3300 ticks; expect: S.POSITION = 136.8 at 3300 ticks
N150 G00 X22
N160 M05
N170 M19 S300 S.POS0
N180 G00 X0 Z2
N190 G331 Z-10 K1.5 S400    ; expect: Z = -3.496667 at 4500 ticks; expect: S.POSITION = 239.2 at 4500 ticks
N200 G332 Z2                ; expect: Z = -4.173333 at 5800 ticks; expect: S.POSITION = 41.6 at 5800 ticks
N210 #MSG ["thread cut, hole tapped"]   ; expect: message "thread cut, hole tapped"; expect: ended
M30
