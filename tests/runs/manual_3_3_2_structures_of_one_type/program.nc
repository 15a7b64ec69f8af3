N10 V.E.LEVEL_1_A[1].SGN16 = -5     ; synchronous: through the queue
N20 V.E.LEVEL_1_A[1].FROZEN = 2.5   ; asynchronous: at once
N30 V.E.LEVEL_1_A[1].LEVEL_2_A[0].LIST[3] = 70
N40 V.CH.Level = V.E.LEVEL_1_A[1]   ; read when the channel is empty, then written
N50 V.E.LEVEL_1_A[2].LEVEL_2_A = V.CH.Level.LEVEL_2_A
N60 V.CH.Table[0] = 9
N70 V.E.LEVEL_1_A[0].LEVEL_2_A[1] = V.CH.Level.LEVEL_2_A[0]

N80 #RT CYCLE [SCOPE = PROG]
  $IF ONCE V.CH.Level.SGN16 < 0
    V.CH.Level.LEVEL_2_A[1].LIST[0] = V.CH.Level.LEVEL_2_A[0].LIST[3] + V.CH.Level.FROZEN
  $ENDIF
#RT CYCLE END
M30
