; Everything that a realtime loop may hold in this version
#RT WHILE [MODULO]
  N10 G00 X10 Y=P1
  N20 G01 X20 F1000
  G02 X30 I5 J0
  G03 X10 R=P2 + 1
  V.E.COUNT = 3
  V.E.VALUE = P1 * 2 + V.E.ASYNC
  Vs.E.ASYNC = 1
#RT ENDWHILE
#RT WHILE
#RT ENDWHILE
M30
; --- words and statements that have no place in it
#RT WHILE
  M100 ; error 22073 "M100"
  G04 X1 ; error 22073 "G04"
  G01 X10 M3 ; error 22073 "M3"
  X[INDP G90 POS=5 G00] ; error 22073 "X"
  G90 ; error 22073 "G90"
  $IF 1 ; error 22073 "$IF"
  $ENDIF
  P1 = 5 ; error 22073 "P1 = 5"
  V.RTG.LOOP.COUNT = 0 ; error 22073 "V.RTG.LOOP.COUNT"
  V.E.ASYNC = 1 ; error 22073 "V.E.ASYNC = 1"
  V.E.COUNT += 1 ; error 22073 "V.E.COUNT"
  X = V.E.VALUE ; error 22073 "V.E.VALUE"
  #FLUSH ; error 22073 "#FLUSH"
  #RT CYCLE [ID = 1 SCOPE = PROG] ; error 22073 "#RT CYCLE"
  #RT CYCLE END
  LL SUB ; error 22073 "LL SUB"
  V.E.NONE = 1 ; error 20196 "V.E.NONE"
#RT ENDWHILE
; --- begins and ends
#RT WHILE
  #RT WHILE ; error 22181 "#RT WHILE"
  #RT ENDWHILE
#RT ENDWHILE
#RT ENDWHILE ; error 22181 "#RT ENDWHILE"
#RT WHILE [SIZE] ; error 20797 "SIZE"
#RT ENDWHILE NOW ; error 20797 "NOW"
#RT WHILE AGAIN ; error 20797 "AGAIN"
#RT ENDWHILE
#RT WHILE ; error 50992 ""
  X10
