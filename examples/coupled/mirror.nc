%mirror
; Two heads on one bridge: the second one mills the mirror image of what the first one mills.
N10 G00 X0 Y20 Y2=180              ; both stand at their parts
N20 #SET AX LINK [1, [Y2=Y, -1, 1]] ; group 1: Y2 goes the way of Y in the other direction
N30 #ENABLE AX LINK [1]            ; from where both stand now
N40 G01 X50 Y50 F9000
N50 G03 X80 Y80 J30
N55 #MSG ["%.3f", V.A.ABS.Y + V.A.ABS.Y2] ; expect: message "200.000"
N60 G01 Y20                        ; expect: Y2.ACS.ACT_POS = 180 at 2946 ticks
N70 #DISABLE AX LINK [1]
N80 #AX LINK ON                    ; group 0 of the channel list: Y2 goes with Y, to the same side
N90 G01 Y60                        ; expect: Y2.ACS.ACT_POS = 220 at end
N100 #AX LINK OFF ALL
N110 M30                           ; expect: ended
