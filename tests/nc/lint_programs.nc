; Cycles that write the same (RC-305)
#RT CYCLE [ID=1]
  V.E.COUNT = 1
  V.E.LIST[1] = 1
  V.RTG.OVERRIDE.VEL.CYCLE = 50
#RT CYCLE END
#RT CYCLE [SCOPE=BLOCK]
  V.E.VALUE1 = 1
  V.E.COUNT = 2 ; note 900244 "line 2 also writes V.E.COUNT, V.RTG.OVERRIDE.VEL.CYCLE"
  V.E.LIST[2] = 1
  V.RTG.OVERRIDE.VEL.CYCLE = 40
  V.E.VALUE = 1
#RT CYCLE END
#RT CYCLE [SCOPE=BLOCK]
  V.E.VALUE = 1
#RT CYCLE END
#RT CYCLE [ID=1] ; error 50900 "the ID 1"
  V.E.LIST[1] = 1
#RT CYCLE END
#RT CYCLE DELETE [ID=1]
#RT CYCLE
  V.E.LIST[1] = 1
  V.E.VALUE1 = 2 ; note 900244 "line 7 also writes V.E.VALUE1"
#RT CYCLE END
M30
#RT CYCLE
  $IF 1
  $ENDIF
#RT CYCLE END
; --- GLOBAL cycles that stay (RC-107)
#RT CYCLE DELETE [ID=1]
#RT CYCLE [ID=1 SCOPE=GLOBAL]
#RT CYCLE END
#RT CYCLE [ID=2 SCOPE=GLOBAL] ; note 900245 "GLOBAL realtime cycle 2"
#RT CYCLE END
P1 = 3
#RT CYCLE DEF [ID=P1 SCOPE=GLOBAL] ; note 900245 "GLOBAL realtime cycle 3"
#RT CYCLE END
#RT CYCLE [ID=4]
#RT CYCLE END
P1 = P1 + 1
#RT CYCLE [ID=P1 SCOPE=GLOBAL]
#RT CYCLE END
#RT CYCLE [SCOPE=GLOBAL]
#RT CYCLE END
#RT CYCLE [ID=0 SCOPE=GLOBAL]
#RT CYCLE END
; --- an ID that is not known deletes any
#RT CYCLE [ID=2 SCOPE=GLOBAL]
#RT CYCLE END
#RT CYCLE DELETE [ID=P1]
#RT CYCLE DELETE
; --- in a subprogram
#RT CYCLE [ID=2 SCOPE=GLOBAL]
#RT CYCLE END
M30
%L END_IT
#RT CYCLE DELETE [ID=2]
M17
; --- parameters: only what is certain
P1 = 1
P2 = 2
P3 = 3
P4 = 4
$IF V.E.VALUE
  P1 = 1
$ELSE
  P2 = 3
$ENDIF
$SWITCH V.E.COUNT
$CASE 1
  P4 = 1
$ENDSWITCH
#RT CYCLE
  V.E.VALUE = P1 ; note 900236 "P1 is read once: in every tick the realtime cycle sees the value"
  V.E.VALUE = P2 ; note 900236 "P2 is read once: in every tick the realtime cycle sees the value"
  V.E.VALUE = P3 ; note 900236 "sees 3, set in line 3"
  V.E.VALUE = P4 ; note 900236 "P4 is read once: in every tick the realtime cycle sees the value"
  V.E.VALUE = P9 ; note 900236 "P9"
#RT CYCLE END
$FOR P5 = 1, 3, 1
  #RT CYCLE [SCOPE=BLOCK]
    V.E.COUNT = P3 ; note 900236 "the value"
    V.E.COUNT = P5 ; note 900236 "the value"
  #RT CYCLE END
  P3 = 4
$ENDFOR
P3 = 5
$IF 0
  P3 = 6
$ENDIF
$WHILE 0
  P3 = 6
$ENDWHILE
#RT CYCLE [SCOPE=BLOCK]
  V.E.TIME = P3 ; note 900236 "sees 5, set in line"
#RT CYCLE END
P3 += 1
#RT CYCLE [SCOPE=BLOCK]
  V.E.TIME = P3 ; note 900236 "the value"
#RT CYCLE END
P3 = 7
P[P1] = 1
#RT CYCLE [SCOPE=BLOCK]
  V.E.TIME = P3 ; note 900236 "the value"
#RT CYCLE END
P3 = 7
P[P1] = 1
P4 = 8
L "other.nc"
#RT CYCLE [SCOPE=BLOCK]
  V.E.TIME = P4 ; note 900236 "the value"
#RT CYCLE END
; --- what empties the channel between G41 and G40 (RC-308)
P1 = V.RTA.ACS.ACT_POS.X
G41 X10
P1 = V.RTA.ACS.ACT_POS.X ; error 20651 "V.RTA.ACS.ACT_POS.X empties the channel, which is not possible while G41"
P1 = V.E.VALUE + Vs.E.ASYNC ; error 20651 "V.E.VALUE" ; error 20651 "V.E.ASYNC"
P1 = V.E.ASYNC
V.E.VALUE = P1
V.E.VALUE += P1 ; error 20651 "V.E.VALUE"
V.RTG.LOOP.COUNT = 1 ; error 20651 "V.RTG.LOOP.COUNT"
P[V.E.COUNT] = 1 ; error 20651 "V.E.COUNT"
V.E.LIST[V.E.COUNT] = 1 ; error 20651 "V.E.COUNT"
V.E.VALUE ; error 20651 "V.E.VALUE"
#FLUSH ; error 20651 "#FLUSH empties"
#FLUSH CONTINUE ; error 20651 "#FLUSH CONTINUE"
#TIME V.E.VALUE ; error 20651 "V.E.VALUE"
#MSG ["%f", V.E.VALUE] ; error 20651 "V.E.VALUE"
N=V.E.COUNT X[V.E.VALUE] ; error 20651 "V.E.COUNT" ; error 20651 "V.E.VALUE"
X[INDP POS=V.E.VALUE G805[V.E.COUNT]] G130[V.E.WORD] ; error 20651 "V.E.VALUE" ; error 20651 "V.E.COUNT" ; error 20651 "V.E.WORD"
$IF V.E.VALUE ; error 20651 "V.E.VALUE"
$ELSEIF V.E.COUNT ; error 20651 "V.E.COUNT"
$ENDIF
$FOR P1 = 1, V.E.COUNT, 1 ; error 20651 "V.E.COUNT"
$ENDFOR
$SWITCH V.E.COUNT ; error 20651 "V.E.COUNT"
$CASE V.E.VALUE ; error 20651 "V.E.VALUE"
$ENDSWITCH
$WHILE V.E.COUNT ; error 20651 "V.E.COUNT"
$ENDWHILE
#RT CYCLE [ID=V.E.COUNT] ; error 20651 "V.E.COUNT"
  V.E.VALUE = V.RTA.ACS.ACT_POS.X
#RT CYCLE END
#RT CYCLE DELETE [ID=3] ; error 20651 "#RT CYCLE DELETE [ID=3] empties"
#CHANNEL INIT [CMDPOS] ; error 20651 "#CHANNEL INIT"
#TIMER READ SYN [ID=1] ; error 20651 "#TIMER READ SYN"
#TIMER READ [ID=1]
G40 X[V.E.VALUE]
P1 = V.E.VALUE
$IF P1
  G42
  P1 = V.E.VALUE ; error 20651 "G42"
$ENDIF
P1 = V.E.VALUE
$IF P1
  G41
$ELSE
  G42
$ENDIF
P1 = V.E.VALUE ; error 20651 "while G41"
$REPEAT
  G40
$UNTIL P1
P1 = V.E.VALUE
$WHILE P1
  G41
$ENDWHILE
P1 = V.E.VALUE
G41
M30
%L SUB
P1 = V.E.VALUE
M17
; ---
; What the program has given an asynchronous variable is told with its line (RC-302).
V.E.ASYNC = 11
V.E.LEVEL_1_A[1].FROZEN = 2.5
#RT CYCLE [SCOPE = PROG]
  V.E.VALUE = V.E.ASYNC ; note 900236 "sees 11, set in line 2"
  V.E.VALUE1 = V.E.LEVEL_1_A[1].FROZEN ; note 900236 "sees 2.5, set in line 3"
#RT CYCLE END
M30
; ---
; So are the program's own variables, unless their type makes another number of the value, or
; another program may write them (RC-302, RC-307).
#VAR
V.P.WIDTH = 3.5
V.P.WHOLE : SGN32 = 3
V.P.LIST[2]
V.L.DEPTH = -2
#ENDVAR
V.P.LIST[1] = 7
V.S.KEPT = 4
#RT CYCLE [SCOPE = PROG]
  V.E.VALUE = V.P.WIDTH + V.P.WHOLE ; note 900236 "V.P.WIDTH is read once: in every tick the realtime cycle sees 3.5, set in line 4" ; note 900236 "sees 3, set in line 5"
  $IF V.E.VALUE > V.P.LIST[1] ; note 900236 "sees 7, set in line 9"
    V.E.VALUE1 = V.L.DEPTH ; note 900236 "sees -2, set in line 7"
    V.E.VALUE2 = V.S.KEPT ; note 900236 "sees the value that it has"
  $ENDIF
  $IF V.P.WIDTH > 3 ; warning 900238 "of V.P.WIDTH it sees 3.5, set in line 4"
    V.E.COUNT = 1
  $ENDIF
#RT CYCLE END
M30
; ---
; A fraction in an asynchronous variable of whole numbers is not told as its value (RC-307).
V.CH.VarTest1 = 2.5 ; warning 901050 "2.5"
#RT CYCLE [SCOPE = PROG]
  V.E.VALUE = V.CH.VarTest1 ; note 900236 "sees the value that it has"
#RT CYCLE END
M30
; ---
; An index that is computed, or a whole structure, leaves nothing certain.
V.E.LEVEL_1_A[1].FROZEN = 2.5
P1 = 0
V.E.LEVEL_1_A[P1].FROZEN = 4
#RT CYCLE [SCOPE = PROG]
  V.E.VALUE1 = V.E.LEVEL_1_A[1].FROZEN ; note 900236 "the value that it has"
#RT CYCLE END
M30
; --- a feed of 0, and arcs of which no radius can be known
G02 X5 ; warning 20036 "no centre"
G02 X5 ; warning 20036 "no centre"
G01 X1 F100
G01 X1 F0 ; error 20176 "feed 0"
G01 X1 F100
G01 X1 F-2.5 ; error 20176 "feed -2.5"
G03
G03 R5
G02 X5
M30
; --- arcs that are one because G02 is active
G02 F100
X10 ; warning 20036 "no centre"
X10 Y10 I5
G91 Y5 ; warning 20036 "no centre"
G92 X5
X5
G02
M100
X5
G03
$IF P1
G00
$ENDIF
X5
G02
G04 X5
X5
G02
F100
G17 X7 ; warning 20036 "no centre"
$FOR P1 = 1, 2, 1
X5
G01
$ENDFOR
G02
G163=5 X5
X10
M30
; --- a radius may come on another way
$IF P1 == 1
  G02 X5 ; warning 20036 "no centre"
  R5
$ENDIF
G02 X6
M30
; --- constants and conditions of programs: types, positions, percentages
#VAR
V.P.LAMP : BOOLEAN = 0
V.P.DEEP : SGN16 = 2.6 ; warning 901050 "V.P.DEEP is of type SGN16: 2.6 is rounded to 3"
V.L.SMALL : UNS08 = 300 ; error 20847 "V.L.SMALL cannot hold 300"
V.P.LIST[3] : UNS08 = [1, 2, 3]
V.P.PART : REAL64 = 2.6
#ENDVAR
V.P.LAMP = 7 ; warning 901051 "V.P.LAMP is of type BOOLEAN: 7 counts as 1"
V.P.LAMP = 1
V.P.DEEP = 70000 ; error 20847 "V.P.DEEP cannot hold 70000: its type ranges from -32768 to 32767"
V.P.DEEP += 0.4 ; warning 901050 "0.4 is rounded to 0"
V.P.LIST[1] = -1 ; error 20847 "V.P.LIST[] cannot hold -1"
V.P.PART = 2.6
#OVERRIDE [FEED_FACT=0.5 RAPID_FACT=50] ; warning 901158 "FEED_FACT=0.5 is an override of 0.5 %"
#OVERRIDE [FEED_FACT=-1] ; error 21826 "FEED_FACT -1"
#OVERRIDE [RAPID_FACT=201] ; error 21419 "RAPID_FACT 201"
#OVERRIDE [FEED_FACT=P1]
X[OVERRIDE FEED_FACT=1] ; warning 901158 "FEED_FACT=1 is"
S[OVERRIDE SPEED_FACT=0.5] ; warning 901158 "SPEED_FACT=0.5 is"
X[OVERRIDE FEED_FACT=120]
$IF V.RTA.ACS.ACT_POS.X > 99999 ; warning 901052 "this comparison is never true"
  $IF V.E.COUNT < 0 ; warning 900239 "V.E.COUNT is of type UNS32: this comparison is never true"
  $ELSEIF 99999 > V.RTA.ACS.CMD_POS.Y ; warning 901052 "always true"
  $ENDIF
$ENDIF
$WHILE V.RTA.ACS.ACT_POS.A > 400 ; warning 901052 "between 0 and 360: this comparison is never true"
$ENDWHILE
$REPEAT
$UNTIL V.RTA.ACS.ACT_POS.X > 500
M30
