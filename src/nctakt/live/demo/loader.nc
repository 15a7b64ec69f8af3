%loader
; Channel 2: the loader brings the next part once the gate is open.
N10 #WAIT SYN [ID=1 CH=1]
N20 G01 U250 F30000
N30 G04 0.2
N40 U0
N50 #SIGNAL SYN [ID=2 CH=1]
M30
