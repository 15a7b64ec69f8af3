%mill
; A rotary table changes its channel: the mill gives it to the loader, and gets it back.
; given: channel 2 loader.nc
N10 G01 X20 C90 F6000        ; the part is milled
N20 #PUT AX [C]              ; the table is free: channel 2 takes it in the same moment
N30 G01 X0                   ; the mill moves on meanwhile
N40 #CALL AX [C, 3, 1]       ; waits until the loader gives it
N50 G01 C0                   ; expect: CH1.C.ACS.ACT_POS = 0 at end
N60 M30                      ; expect: ended
