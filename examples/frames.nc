%L POCKET
; One pocket, as it is drawn
G00 X10 Y5
G01 Z-2 F1000
X40 F4000
Y20
X30
G03 X25 Y15 I0 J-5
G01 Y10
X10
Y5
G00 Z5
M17
%frames
; One pocket in four places: as drawn, mirrored, turned, and half as large. Look at it:
;   nctakt run examples/frames.nc --plot frames.html
#RT CYCLE [SCOPE=PROG]
  $IF EDGE V.RTA.ACS.ACT_POS.Z < -1
    V.E.COUNT += 1         ; pockets that are begun
  $ENDIF
#RT CYCLE END
N10 G00 Z5
N20 LL POCKET
N30 G21                    ; x becomes -x, and arcs turn the other way round
N40 LL POCKET
N50 G20
N60 #ROTATION ON [ANGLE=180]
N70 LL POCKET
N80 #ROTATION OFF
N90 G22
N100 #SCALE ON X0.5 Y0.5   ; the fourth one is mirrored downwards and half as large
N110 LL POCKET
N120 #SCALE OFF
N130 G20
N140 G00 X0 Y0
N150 M30
