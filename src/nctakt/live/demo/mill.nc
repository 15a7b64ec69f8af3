%mill
; Channel 1 mills with five axes. M100 asks the PLC to open the gate, M8 is done once it is open.
#RT CYCLE [ID = 1 SCOPE = PROG]
  $IF EDGE V.RTA.ACS.ACT_POS.Z > 160     ; the tool is up
    $IF V.E.AREA_FREE == TRUE            ; the scanner sees no one at the gate
      M100
    $ENDIF
  $ENDIF
#RT CYCLE END
N10 D1
N20 S3000 M3
N30 #TRAFO ON                            ; X Y Z are those of the tip
N40 G00 X20 Y20 Z20
N50 G01 Z0 F9000
N60 X140 A20
N70 Y90 C60
N80 X20 A30
N90 Y20 C0 A0
N100 #TRAFO OFF
N110 G01 Z190 F12000
N120 M8                                  ; the loader comes through the open gate
N130 #SIGNAL SYN [ID=1 CH=2]
N140 #WAIT SYN [ID=2 CH=2]
N150 V.E.PARTS = V.E.PARTS + 1
N160 M9
M30
