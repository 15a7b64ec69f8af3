%no_feed
; A mistake that has to be told before anything moves
N10 G01 X10 F0                           ; expect: error 20176
M30
