; X stands at 0 already
G00 X0

#RT CYCLE [SCOPE = PROG]

  $IF ONCE V.RTA.ACS.ACT_POS.X > 200

    ; out in this very tick, nobody waits for it
    M100

  $ENDIF

#RT CYCLE END

G00 X300

M30
