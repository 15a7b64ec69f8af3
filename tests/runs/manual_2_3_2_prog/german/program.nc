#TIME 0.002

; Ein Zyklus für den Rest des Programms.
#RT CYCLE [SCOPE = PROG]
  V.E.COUNT += 1
#RT CYCLE END

; von hier an arbeitet er, durch jeden Satz
#TIME 0.002
#TIME 0.002

M30
; hier ist er weg
