; Slips of newcomers: a condition
$IF V.E.COUNT = 5 ; error 20797 "'=' assigns a value"
M100
$ENDIF
$WHILE P1 = 5 ; error 20797 "'=' assigns a value"
$ENDWHILE
$IF V.E.COUNT > 5 AND V.E.COUNT < 10 ; error 20797 "'AND' is not an operator"
M100
$ELSE IF V.E.COUNT > 5 OR P1 ; error 900107 "$ELSE IF" ; error 20797 "'OR' is not an operator"
M101
$ELSIF P1 EQ 3 ; error 900107 "$ELSIF" ; error 20797 "'EQ' is not an operator"
M101
$END IF ; error 900107 "$END IF"
$IF V.E.COUNT > 5 THEN ; error 20797 "without THEN"
M100
$ENDIF
$IF V.E.COUNT > 5 M100 $ENDIF ; error 20797 "M100 is in the line of the condition"
$IF V.E.COUNT <> 5 ; error 900101 "'<>' is not an operator"
$ENDIF
$IF V.E.COUNT => 5 ; error 20797 "'=>' is not an operator"
$ENDIF
$IF (V.E.COUNT > 5) ; error 900101 "(V.E.COUNT > 5) is a comment"
$ENDIF
$WHILE P1 < 10 DO ; error 20797 "without DO"
$ENDWHILE
$FOR P1 = 1 TO 10 ; error 20229 "TO does not separate"
$ENDFOR
IF P1 == 3 ; error 20797 "IF needs the sign"
GOTO 10 ; error 20797 "GOTO needs the sign"
; --- realtime cycles
#RT CYCLE [ID=1 SCOPE=PROG]
  $IF EDG V.E.COUNT > 5 ; error 20392 "'EDG' does not say how often"
    M100
  $ENDIF
#RT CYCLE END
#RT CYCLE [DEF ID=2 SCOPE=PROG] ; error 21985 "the word in '[DEF'"
  V.E.COUNT = 1
#RT CYCLE END
#RT CYLCE [ID=3 SCOPE=PROG] ; error 20509 "#RT CYLCE"
  V.E.COUNT = 1
#RT CYCLE END
#RT CYCLE STOP [ID=3] ; error 21985 "#RT CYCLE has no command STOP"
#RT CYCLE DELETE ID=3 ; error 20797 "ID=3 needs square brackets"
RT CYCLE DELETE [ID=3] ; error 20797 "RT CYCLE needs the sign"
G01 X10 F1000
; --- a realtime cycle without its end: what follows belongs to the program
#RT CYCLE [ID=1 SCOPE=PROG] ; error 22005 "#RT CYCLE"
  $IF EDGE V.E.COUNT > 5
    M100
  $ENDIF
G01 X10 F1000
G02 X20 I5 J0
$WHILE P1 < 3
  P1 += 1
$ENDWHILE
M30
; --- words of structures from other languages
$FOR P1 = 1, 10, 1
$NEXT ; error 900107 "$NEXT"
$WHILE P1 < 3
  P1 += 1
$WEND ; error 900107 "$WEND"
#VAR
  V.P.A = 3
#END VAR ; error 20509 "#END VAR"
#RTCYCLE [ID=1 SCOPE=PROG] ; error 20509 "#RTCYCLE"
  $IF EGDE V.E.COUNT > 5 ; error 20392 "'EGDE' does not say how often"
    V.E.COUNT = 1
  $ELSEIF V.E.COUNT > 7
    V.E.COUNT = 2
  $ENDIF
  $IF RISING V.E.COUNT > 5 ; error 20392 "'RISING' does not say how often"
    V.E.COUNT = 1
  $ENDIF
#RT CYCLE_END ; error 20509 "#RT CYCLE_END"
#RT CYCLE [ID=2 SCOPE=PROG]
  V.E.COUNT = 1
#END RT CYCLE ; error 20509 "#END RT CYCLE"
$IF P1 === 3 ; error 900101 "'===' is not an operator"
$ENDIF
$GOTO 100 ; error 900114 "100 needs the sign"
N100: G01 X1 F100
RETURN ; error 20797 "BASIC, for the end of a subprogram"
WAIT 5 ; error 20797 "BASIC, for a dwell"
STOP ; error 20797 "BASIC, for a halt"
END ; error 20797 "BASIC, for the end of a program"
G01 X10
M30
; --- names, units, steps
VE.COUNT = 3 ; error 20797 "VE.COUNT is not a variable"
V,E.COUNT = 3 ; error 20797 "V,E.COUNT is not a variable"
++P1 ; error 20797 "++P1"
G01 X10mm F100 ; error 20797 "values have no unit"
G01 F500mm/min ; error 20797 "values have no unit"
HLI.OVERRIDE = 50 ; error 20797 "name of the interface to the PLC"
gpCh[0]^.cycle_data.cycletime = 1 ; error 900101 "name of the interface to the PLC"
V.E.COUNT = HLI.OVERRIDE ; error 20392 "name of the interface to the PLC"
G01 X1
M30
; --- values
G01 X1,5 F1000 ; error 20797 "1,5 is not a number"
P1 = 1,5 ; error 20797 "1,5 is not a number"
G00 X1O ; error 20797 "a letter in place of a digit"
P1++ ; error 20797 "P1++"
V.E.COUNT-- ; error 20797 "V.E.COUNT--"
P1 = (3+4)*2 ; error 900101 "(3+4) is a comment"
G01 X(P1+1) F100 ; error 900208 "(P1+1) is a comment"
P1 = SIN 30 ; error 20797 "brackets around its argument"
P1 = 5 % 3 ; error 20797 "'%' is not an operator"
P1 := 5 ; error 20797 "':=' is not an operator"
P1 == 5 ; error 20797 "'==' compares; it does not assign"
G01 X10 // go ; error 900101 "does not begin a comment"
/* text */ ; error 20797 "does not begin a comment"
; --- words of other controls
G43 H1 ; error 20131 "tool length"
G49 ; error 20131 "tool length"
G91 G28 Z0 ; error 20131 "reference point"
G54.1 P3 ; error 20107 "zero offset"
G65 P1000 ; error 20131 "subprogram"
M98 P1234 ; error 20157 "subprogram"
M99 ; error 20157 "end of a subprogram"
O1234 ; error 20797 "begin of a program"
#100 = 5 ; error 900114 "Fanuc, for a variable"
LBL 1 ; error 20797 "Heidenhain"
TOOL CALL 1 Z S2000 ; error 20797 "tool change"
BEGIN PGM TEST MM ; error 20797 "Heidenhain"
Q1 = 5 ; error 20797 "Heidenhain, for a variable"
R1 = 5 ; error 20797 "Sinumerik, for a variable"
STOPRE ; error 20797 "Sinumerik"
; --- curly brackets
#RT CYCLE [ID=1 SCOPE=PROG] { ; error 20797 "{: curly brackets"
  $IF EDGE V.E.COUNT > 5
    M100
  $ENDIF
}
#RT CYCLE [ID=2 SCOPE=PROG]
{ ; error 20797 "{: curly brackets"
  V.E.COUNT = 1
}
#RT CYCLE END
$IF {V.E.COUNT > 5} ; error 900101 "{V.E.COUNT > 5}: curly brackets"
M100
$ENDIF
; --- a body in curly brackets
$IF V.E.COUNT > 5 { ; error 20797 "{: curly brackets"
M100
}
G01 X10 F100
; --- round brackets and none of the signs =
#RT CYCLE (ID=1 SCOPE=PROG) ; error 20797 "(ID=1 SCOPE=PROG) is a comment"
  V.E.COUNT = 1
#RT CYCLE END
#RT CYCLE [ID 2 SCOPE PROG] ; error 900208 "ID 2 SCOPE PROG: the sign ="
  V.E.COUNT = 1
#RT CYCLE END
#RT CYCLE [ID=3 SCOPE PROG] ; error 21985 "SCOPE PROG: the sign ="
  V.E.COUNT = 1
#RT CYCLE END
#RT CYCLE DELETE (ID=1) ; error 20797 "(ID=1) is a comment"
; --- a condition with its body in one line
$IF V.E.COUNT > 5 THEN M100 ; error 20797 "THEN M100: a condition ends with its line"
G01 X10 F100
