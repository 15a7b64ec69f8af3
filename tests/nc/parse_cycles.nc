; Definitions in all forms that RC-101 allows
#RT CYCLE
#RT CYCLE END
#RT CYCLE [SCOPE = PROG]
#RT CYCLE END
#RT CYCLE DEF[ID=15 SCOPE=BLOCK END_ACTION=MOVE_ABORT]
#RT CYCLE END
N10 #rt cycle def [ end_action = move_cont  scope=global id =3 ]
N20 #rt cycle end
#RT CYCLE START [ID=15]
#RT CYCLE HOLD[ID = 15]
#RT CYCLE CONTINUE [ ID=15 ]
#RT CYCLE ABORT ACTION [ID=P1+1]
#RT CYCLE DELETE [ID=15]
M30
; --- END without begin
G0 X1
#RT CYCLE END ; error 22005 "#RT CYCLE END"
M30
; --- begin without END
G0 X1
#RT CYCLE [ID=1 SCOPE=PROG] ; error 22005 "#RT CYCLE"
M100
; --- begin without END, then a second definition
#RT CYCLE [ID=1 SCOPE=PROG] ; error 22005 "#RT CYCLE"
M100
#RT CYCLE [ID=2 SCOPE=PROG]
M101
#RT CYCLE END
M30
; --- a definition inside a definition, not inside $IF
#RT CYCLE [ID=1 SCOPE=PROG] ; error 22005 "#RT CYCLE"
#RT CYCLE [ID=2 SCOPE=PROG]
M101
#RT CYCLE END
#RT CYCLE END
M30
#RT CYCLE END ; warning 900118 "after the program end"
; --- a definition inside a definition, inside $IF
#RT CYCLE [ID=1 SCOPE=PROG]
$IF V.E.A
  #RT CYCLE [ID=2 SCOPE=PROG] ; error 22005 "#RT CYCLE"
    M101
  #RT CYCLE END
$ENDIF
#RT CYCLE END
G0 X1
; --- a word that #RT CYCLE does not have; its END is no second mistake
#RT CYCLE DFE [ID=1 SCOPE=PROG] ; error 21985 "DFE"
M100
#RT CYCLE END
#RT CYCLE END ; error 22005 "#RT CYCLE END"
; --- $IF left open inside a cycle
#RT CYCLE [SCOPE=PROG]
  $IF ONCE V.RTA.ACS.ACT_POS.X > 200 ; error 20375 "$IF"
    M100
#RT CYCLE END
G0 X1
; --- a cycle left open inside $IF
$IF P1 == 1
  #RT CYCLE [SCOPE=PROG] ; error 22005 "#RT CYCLE"
    M100
$ENDIF
#RT CYCLE END
G0 X1
; --- an '=' before the condition, as the manual's syntax line has it (2.7.2)
#RT CYCLE [ID = 99]
  $IF ONCE = V.E.COUNT > 5 ; error 901041 "there must be no '=' between"
    M100
  $ENDIF
  $IF = V.E.COUNT == 5 ; error 901041 "$IF"
    V.E.COUNT = 0
  $ELSEIF = V.E.COUNT == 6 ; error 901041 "$ELSEIF"
    V.E.COUNT = 1
  $ENDIF
#RT CYCLE END
; --- brackets of the definition's line
#RT CYCLE [SCOPE=PROG ; error 20397 "bracket"
M100
#RT CYCLE END
#RT CYCLE DELETE ID=4 ; error 20797 "ID"
#RT CYCLE [ID=5] [SCOPE=PROG] ; error 20797 "["
#RT CYCLE END
#RT CYCLE [ID=] ; error 900101 "]"
#RT CYCLE END X1 ; error 20797 "X"
M30
; --- a program that ends inside a cycle
%MAIN
#RT CYCLE [SCOPE=PROG] ; error 22005 "#RT CYCLE"
M100
%L SUB
G0 X1
M17
