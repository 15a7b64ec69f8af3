#TIME 0.002

; A cycle for the rest of this program.
#RT CYCLE [SCOPE = PROG]
  V.E.COUNT += 1
#RT CYCLE END

; from here on it is at work, through every block
#TIME 0.002
#TIME 0.002

M30
; here it is gone
