; X steht schon auf 0: ein Weg ohne Länge
G00 X0

; den Zyklus ablegen
#RT CYCLE DEF [ID = 17 SCOPE = PROG]

  ; wenn X einmal über 200 gegangen ist
  $IF ONCE V.RTA.ACS.ACT_POS.X > 200
    M100
  $ENDIF

  ; etwas, das er nur sieht, solange er nicht angehalten ist
  $IF EDGE V.E.TRIGGER == 1
    V.E.COUNT += 1
  $ENDIF

#RT CYCLE END

; noch nicht gestartet
G00 X50

#RT CYCLE START [ID = 17]

; auf diesem Weg kommt M100
G00 X250

#RT CYCLE HOLD [ID = 17]
#TIME 0.01
#RT CYCLE CONTINUE [ID = 17]
#TIME 0.01

; Zyklus 17 endet mit dem Programm
M30
