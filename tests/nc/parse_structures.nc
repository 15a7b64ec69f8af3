; Every structure, with and without block numbers, nested
N10 $IF P1 > 2
N20 G1 X1
N30 $ELSEIF P1 < 0
N40 G1 X2
N50 $ELSE
N60 G1 X3
N70 $ENDIF
$IF P1 $GOTO N20
$IF V.L.A < 3 $GOTO [LOOP]
$FOR P1 = 0, 4, 1
  $FOR V.P.I = 10, -10, -0.5
    $BREAK
  $ENDFOR
  $CONTINUE
$ENDFOR
$WHILE V.E.GO
  $DO
    P2 += 1
  $ENDDO P2 < 5
$ENDWHILE
$REPEAT
  P2 -= 1
$UNTIL P2 <= 0
$SWITCH P3
$CASE 1
  G0 X1
  $BREAK
$CASE 2
$DEFAULT
  G0 X2
$ENDSWITCH
#IF V.G.VERSION > 3
G0 X4
#ELSE
G0 X5
#ENDIF
N20: G0 X1
[LOOP] G0 X2
$GOTO N020
$GOTO [loop]
$if once p1 > 3
$endif
M30
; --- structures that are never closed
$IF P1 ; error 20375 "$IF"
  $FOR P1 = 1, 2, 1 ; error 20375 "$FOR"
    $WHILE 1 ; error 20375 "$WHILE"
      $DO ; error 20375 "$DO"
        $REPEAT ; error 20375 "$REPEAT"
          $SWITCH P1 ; error 20375 "$SWITCH"
          $CASE 1
          #VAR ; error 20375 "#VAR"
; --- ends without a begin
$ENDIF ; error 20218 "$ENDIF without $IF"
$ELSE ; error 20214 "$ELSE without $IF"
$ELSEIF P1 ; error 20216 "$ELSEIF without $IF"
$ENDFOR ; error 20232 "$ENDFOR without $FOR"
$ENDWHILE ; error 20237 "$ENDWHILE without $WHILE"
$ENDDO 1 ; error 20240 "$ENDDO without $DO"
$UNTIL 1 ; error 21469 "$UNTIL without $REPEAT"
$CASE 1 ; error 20221 "$CASE without $SWITCH"
$DEFAULT ; error 20223 "$DEFAULT without $SWITCH"
$ENDSWITCH ; error 20225 "$ENDSWITCH without $SWITCH"
#ENDVAR ; error 900106 "#ENDVAR without #VAR"
#ENDIF ; error 20592 "#ENDIF without #IF"
#COMMENT END ; error 20567 "#COMMENT END without #COMMENT BEGIN"
; --- a $ENDIF does not close #IF
#IF 1 ; error 21387 "#IF"
$ENDIF ; error 20218 "$ENDIF"
; --- an inner structure that is left open
$WHILE P1
  $IF P2 ; error 20375 "$IF"
$ENDWHILE
G0 X1
; --- $ELSE twice, $ELSEIF behind $ELSE
$IF P1
$ELSE
$ELSE ; error 20214 "$ELSE after"
$ELSEIF P2 ; error 20216 "$ELSEIF after"
$ENDIF
; --- a condition that cannot be read does not make its end a mistake
$IF P1 > ; error 900101 "the end of the block"
$ELSEIF * ; error 900101 "*"
$ENDIF
$IF P1 > $GOTO N20 ; error 900101 "$"
$WHILE ; error 900101 "the end of the block"
$ENDWHILE
$FOR P1 = 1 ; error 20229 "','"
$ENDFOR
$FOR 3 = 1, 2, 3 ; error 900114 "3"
$ENDFOR
$FOR P1 1, 2, 3 ; error 20228 "'='"
$ENDFOR
$SWITCH ; error 900101 "the end of the block"
$CASE ; error 900101 "the end of the block"
$ENDSWITCH
$DO
$ENDDO ; error 900101 "the end of the block"
; --- something behind the words
$ELSE X10 ; error 20214 "$ELSE"
$IF P1
$ELSE X10 ; error 20797 "X"
$ENDIF X ; error 20797 "X"
$IF P1 G0 X10 ; error 20797 "G"
$ENDIF
$IF P1 $ENDIF ; error 20797 "$ENDIF"
$GOTO ; error 900114 "the end of the block"
$GOTO 5 ; error 900114 "5"
$BREAK 5 ; error 20797 "5"
; --- words that do not exist
$WHEN P1 ; error 900107 "$WHEN"
$ IF P1 ; error 900107 "$"
$ENDFI ; error 900107 "$ENDFI"
; --- a statement before the first $CASE
$SWITCH P1
G0 X1 ; error 900115 "$CASE"
$CASE 1
G0 X2
$ENDSWITCH
; --- what can never run need not be NC text, but structures in it count
$IF 0
  this :: is no NC text
  $IF P1
    !!
  $ENDIF
$ELSE
  :: ; error 20797 ":"
$ENDIF
$IF FALSE
  ::
$ENDIF
$WHILE 0
  ::
$ENDWHILE
; --- text behind the program end is read with patience, until the next %
G0 X1
M30
N20: G0 X2
This file was made by hand: do not change! ; warning 900118 "after the program end"
:: more of it
$ENDIF
%L SUB
G0 X1 :: ; error 20797 ":"
M17
more text: see above ; warning 900118 "after the program end"
; --- a skipped program end is none, nor is one inside a structure
/ M30
:: ; error 20797 ":"
$IF P1
M30
$ENDIF
:: ; error 20797 ":"
; --- declarations
#VAR
  V.L.A
  V.L.B = 10.67
  V.L.C : UNS32 = 10
  N30 V.L.D : STRING[20] = "PLATE"
  V.P.E[3][2] = [1, 2, \
    3, 4, \
    5, 6]
  V.P.F[3] : REAL64 = [1,
    V.P.B, ; a comment in between

    3]
  V.CYC.G[P1][P2] : STRING[P3]
  V.L.H = "["
  N40: V.L.I
#ENDVAR
; --- mistakes inside declarations
#VAR
  V.L.A : ; error 900114 "the end of the block"
  V.L. ; error 900114 "the end of the block"
  V.L.B = ; error 900101 "the end of the block"
  some words ; error 900116 "declarations"
  V.L.C : SGN08 foo ; error 20797 "foo"
  V.L.E = [1, 2 ; error 20397 "bracket"
  V.L.F = 3
#ENDVAR
G0 X1
; --- a forgotten #ENDVAR is noticed at the second block that declares nothing
#VAR ; error 20375 "#VAR"
  V.L.A
G0 X1 ; error 900116 "declarations"
G0 X2
G0 X3
; --- a forgotten #ENDVAR before a structure
#VAR ; error 20375 "#VAR"
  V.L.A
$IF P1
$ENDIF
; --- several programs in one file
%L SUB1
M17
%MAIN
G0 X1
% this is a comment in the main program
G0 X2
M30
%L SUB2
M29
%OTHER ; error 20193 "%OTHER"
G0 X3
; --- a value in brackets that ends with the file
#VAR ; error 20375 "#VAR"
V.L.A = [1, ; error 900101 "the end of the block"
