%part
; a part is loaded and clamped, then machined while the gate is open
; expect: ended
#RT CYCLE [ID = 4 SCOPE = PROG]
  $IF ONCE V.RTA.ACS.ACT_POS.X > 200
    M100                                 ; expect: M100 once
  $ENDIF
#RT CYCLE END
N5 G04 0.02                              ; the PLC announces itself in its first cycles; then M7 waits for it
N10 M7                                   ; given: MAIN.bGateDown = 0 at 0.05s; given: MAIN.bGateUp = 1 at 0.1s
N20 M6                                   ; expect: A.ACS.ACT_POS = 90 at 1.027s
N30 M10                                  ; given: MAIN.bReleased = 0 at 2.2s; given: MAIN.bClamped = 1 at 2.3s
N40 S1000 M3
N50 G01 X400 F12000
N60 M5
N70 M11                                  ; given: MAIN.bClamped = 0 at 5.4s; given: MAIN.bReleased = 1 at 5.5s
N80 M9                                   ; given: MAIN.bGateUp = 0 at 5.6s; given: MAIN.bGateDown = 1 at 5.7s
M30                                      ; expect: MAIN.bAlarm = 0 at end
