; Everything that a cycle may hold in this version
#RT CYCLE [ID = 1 SCOPE = PROG END_ACTION = MOVE_CONT]
  N10 $IF ONCE V.RTA.ACS.ACT_POS.X > 200
    N20 M100 M101
    M116 H100 H114
  $ENDIF
  $IF EDGE V.E.TRIGGER == 1
    $IF ALWAYS V.E.VALUE
    $ENDIF
  $ENDIF
  $IF V.E.VALUE > P1
    V.E.VALUE = SQRT[ABS[V.E.ASYNC]] + P1
    V.E.COUNT += 1
    V.E.LIST[V.E.COUNT] -= 2
  $ELSEIF V.CH.VarTest1 < 3
    Vs.CH.VarTest1 = Vs.CH.VarTest1 + 1
    V.CH.Total *= 2
  $ELSE
    V.RTG.OVERRIDE.VEL.CYCLE = 75
    V.RTA.OVERRIDE.VEL.CYCLE.X = 50
    V.RTG.LOOP.COUNT /= 2
  $ENDIF
  V.E.VALUE
  V.E.LEVEL_1_A[0].REAL64 = V.E.LEVEL_1_A[0].REAL64
  Vs.E.LEVEL_1_A[V.E.COUNT].FROZEN = 1
  /2 N30
#RT CYCLE END
#RT CYCLE
#RT CYCLE END
#RT CYCLE DEF [ID = P1 SCOPE = GLOBAL]
#RT CYCLE END
#RT CYCLE START [ID=1]
#RT CYCLE DELETE [ID = P1 + 1]
M30
; --- keywords (RC-101, RC-103, RC-104)
#RT CYCLE [ID=1 SKOPE=PROG] ; error 21985 "SKOPE"
#RT CYCLE END
#RT CYCLE [5] ; error 21985 "5"
#RT CYCLE END
#RT CYCLE [ID[1]] ; error 21985 "ID"
#RT CYCLE END
#RT CYCLE [SCOPE=PROGRAM] ; error 900225 "SCOPE = PROGRAM"
#RT CYCLE END
#RT CYCLE [SCOPE] ; error 900225 "SCOPE = –"
#RT CYCLE END
#RT CYCLE [SCOPE=3] ; error 900225 "SCOPE = 3"
#RT CYCLE END
#RT CYCLE [END_ACTION=ABORT] ; error 900225 "END_ACTION = ABORT"
#RT CYCLE END
#RT CYCLE [ID=1 ID=2] ; error 21887 "ID"
#RT CYCLE END
#RT CYCLE [SCOPE=PROG SCOPE=BLOCK] ; error 21887 "SCOPE"
#RT CYCLE END
#RT CYCLE DEF ; error 22003 "DEF"
#RT CYCLE END
#RT CYCLE DEF [SCOPE=GLOBAL] ; error 22003 "DEF"
#RT CYCLE END
#RT CYCLE [SCOPE=GLOBAL] ; error 22003 "SCOPE=GLOBAL"
#RT CYCLE END
#RT CYCLE [ID SCOPE=PROG] ; error 900208 "ID"
#RT CYCLE END
#RT CYCLE [ID=0 SCOPE=PROG] ; error 50875 "0 is not a valid ID of a realtime cycle"
#RT CYCLE END
#RT CYCLE [ID=-3] ; error 50875 "-3"
#RT CYCLE END
#RT CYCLE [ID=1.5 SCOPE=GLOBAL] ; error 50875 "1.5"
#RT CYCLE END
#RT CYCLE [ID=0 SCOPE=GLOBAL] ; error 21983 "not 0"
#RT CYCLE END
#RT CYCLE [ID=-1 SCOPE=GLOBAL] ; error 21983 "not -1"
#RT CYCLE END
#RT CYCLE [ID=V.E.NONE] ; error 20196 "V.E.NONE"
#RT CYCLE END
; --- management commands (RC-111)
#RT CYCLE START ; error 900226 "#RT CYCLE START"
#RT CYCLE ABORT ACTION ; error 900226 "#RT CYCLE ABORT ACTION"
#RT CYCLE HOLD [ID=0] ; error 50875 "0"
#RT CYCLE CONTINUE [ID=1 SCOPE=PROG] ; error 21985 "SCOPE"
#RT CYCLE DELETE [ID=V.E.NONE] ; error 20196 "V.E.NONE"
#RT CYCLE DELETE [ID=0] ; error 50875 "0"
; --- $IF (RC-203)
#RT CYCLE
  $IF ONCE V.E.VALUE > 1
  $ELSE ; error 22022 "$IF ONCE"
    V.E.NONE = 1 ; error 20196 "V.E.NONE"
  $ENDIF
  $IF EDGE V.E.VALUE > 1
  $ELSEIF V.E.VALUE ; error 22022 "$IF EDGE"
  $ENDIF
  $IF V.E.VALUE > 1
  $ELSEIF ALWAYS V.E.NONE ; error 22021 "ALWAYS"; error 20196 "V.E.NONE"
  $ENDIF
  $IF V.E.NONE ; error 20196 "V.E.NONE"
    M99 ; error 50938 "M99"
  $ENDIF
  $IF 0
    ::: ; error 900229 "this block is not valid NC text"
  $ENDIF
  #IF V.E.VALUE ; error 22002 "#IF"
  #ENDIF
#RT CYCLE END
; --- constructs without meaning in a cycle (RC-208)
#RT CYCLE
  G00 X100 ; error 22002 "G00"
  X1 Y2 ; error 22002 "X1"
  F100 ; error 22002 "F100"
  T1 ; error 22002 "T1"
  M100 G01 X1 ; error 22002 "G01"
  $FOR P1 = 1, 2, 1 ; error 22002 "$FOR"
    G00 X1
  $ENDFOR
  $WHILE 1 ; error 22002 "$WHILE"
  $ENDWHILE
  $DO ; error 22002 "$DO"
  $ENDDO 1
  $REPEAT ; error 22002 "$REPEAT"
  $UNTIL 1
  $SWITCH P1 ; error 22002 "$SWITCH"
  $CASE 1
  $ENDSWITCH
  $GOTO N10 ; error 22002 "$GOTO"
  $BREAK ; error 22002 "$BREAK"
  $CONTINUE ; error 22002 "$CONTINUE"
  L file ; error 22002 "L file"
  LL SUB ; error 22002 "LL SUB"
  "A" = "B" ; error 22002 ""
  #VAR ; error 22002 "#VAR"
  #ENDVAR
  #RT CYCLE START [ID=1] ; error 22002 "#RT CYCLE START"
  #FLUSH ; error 22002 "#FLUSH"
  #TIME 1 ; error 22002 "#TIME 1"
  #MSG ["x"] ; error 22002 "#MSG"
  #SLOPE [TYPE=TRAPEZ] ; error 22002 "#SLOPE"
  #RT WHILE ; error 22002 "#RT WHILE"
  #RT ENDWHILE
  #FOO ; error 20509 "#FOO"
#RT CYCLE END
; --- variables (RC-301 … RC-303)
#RT CYCLE
  V.E.ASYNC = 1 ; error 22009 "V.E.ASYNC is asynchronous"
  V.E.ASYNC += 1 ; error 22009 "V.E.ASYNC"
  V.CH.VarTest1 = 1 ; error 22009 "V.CH.VarTest1"
  V.E.LEVEL_1_A[0].FROZEN = 1 ; error 22009 "V.E.LEVEL_1_A[].FROZEN"
  Vs.E.ASYNC = 1
  Vs.E.ASYNC = V.E.ASYNC ; error 900228 "V.E.ASYNC"
  P1 = 3 ; error 22009 "P1"
  P[P1] = 3 ; error 22009 "P is"
  V.P.A = 3 ; error 22009 "V.P.A"
  V.L.A[1] = 3 ; error 22009 "V.L.A[]"
  V.E.VALUE = V.P.A
  V.E.INPUT = 1 ; error 20100 "V.E.INPUT"
  V.E.VALUE = V.E.OUTPUT ; error 20097 "V.E.OUTPUT"
  V.E.VALUE = V.RTG.MEAS_DELTA ; error 21993 "R access to V.RTG.MEAS_DELTA is not available here: program R/W, realtime cycle –"
  V.RTG.MEAS_DELTA = 1 ; error 21993 "W access to V.RTG.MEAS_DELTA"
  V.RTG.OVERRIDE.VEL.TOTAL = 50 ; error 21993 "V.RTG.OVERRIDE.VEL.TOTAL"
  V.RTG.TIMER[0] = 0 ; error 21993 "V.RTG.TIMER[]"
  V.RTA.ACS.ACT_POS.X = 0 ; error 21993 "V.RTA.ACS.ACT_POS.X"
  V.RTA.FIXED_STOP.ACTIVE.X += 1 ; error 21993 "V.RTA.FIXED_STOP.ACTIVE.X"
  V.E.TEXT = 1 ; error 21460 "1"
  V.E.VALUE = V.E.TEXT ; error 21981 "V.E.TEXT"
  V.E.VALUE = "text" ; error 21981 ""
  V.E.NOTHING = 1 ; error 20196 "V.E.NOTHING"
  V.E.LIST = 1 ; error 21216 "V.E.LIST"
  V.E.LIST[10] = 1 ; error 50895 "10"
  V.E.LIST[0] = V.E.LIST[12] ; error 50895 "12"
  V.E.LEVEL_1_A[0].REAL64 = V.E.LEVEL_1_A[0] ; error 900215 "V.E.LEVEL_1_A[]"
  V.E.LEVEL_1_A[0] = V.E.LEVEL_1_A[1] ; error 22009 "V.E.LEVEL_1_A[].FROZEN"
  V.CH.Level = V.E.LEVEL_1_A[1] ; error 22009 "V.CH.Level.FROZEN"
  V.E.LEVEL_1_A[0] = V.E.LIST ; error 21443 "V.E.LIST"
  V.E.LEVEL_1_A[0] = [1, 2] ; error 22001 "V.E.LEVEL_1_A[]"
  V.E.LIST = [1, 2] ; error 22001 "V.E.LIST"
  P1 = [1, 2] ; error 22001 "P"
  V.E.VALUE = V.E.LEVEL_1_A[V.E.COUNT].FROZEN ; warning 900227 "V.E.LEVEL_1_A[].FROZEN"
  V.E.VALUE = P[V.E.COUNT] ; warning 900227 "P"
  V.E.VALUE = P[P1]
  V.E.VALUE = V.E.LEVEL_1_A[P1].FROZEN
#RT CYCLE END
; --- expressions
#RT CYCLE
  V.E.VALUE = EXIST[V.P.A] ; error 900220 "EXIST"
  V.E.VALUE = SIZEOF[V.E.LIST] ; error 900220 "SIZEOF"
  V.E.VALUE = SINUS[1] ; error 20392 "SINUS"
  V.E.VALUE = SIN[1, 2] ; error 21474 "SIN"
  V.E.VALUE = FOO ; error 20392 "FOO"
#RT CYCLE END
; --- M and H functions (RC-403)
#RT CYCLE
  M99 ; error 50938 "M99"
  H99 ; error 50940 "H99"
  M0 ; error 900207 "M00"
  M1 M2 ; error 900207 "M01"; error 900207 "M02"
  M17 ; error 900207 "M17"
  M29 ; error 900207 "M29"
  M30 ; error 900207 "M30"
  M200 ; error 900206 "M200 belongs to axis X"
  H200 ; error 900206 "H200 belongs to axis X"
  M110=130 ; error 900200 "M110=130"
  M[P1] ; error 900200 "computed number"
  M ; error 900208 "M"
  M1.5 ; error 20154 "M1.5"
  "MACRO" ; error 22002 ""
#RT CYCLE END
; --- spindles and single axes: later versions
#RT CYCLE
  M03 S1000
  M03 M19 S1000 S.POS314 M100
  S2[M03 REV=1000] S[M5]
  M03 ; error 50954 "M03"
  S1000 ; error 50954 "S1000"
  M05 S1000 ; error 50954 "M05"
  M03 M04 S1000 ; error 50954 "M03"
  M19 S1000 S.POS314 ; error 50954 "M19"
  M03 M19 S1000 ; error 50954 "M03"
  S2[M04 REV=10 POS=3] ; error 50954 "S2["
  S2[M04 REV=V.E.COUNT + 1 M100] ; error 21035 "M does"
  Z [INDP ABORTING G01 G90 FEED=500 POS=900 OFFSET=ALL]
  Q[INDP STOP] ; error 20797 "Q"
#RT CYCLE END
; --- #TIMER and #ERROR (RC-401, RC-402)
#RT CYCLE
  #TIMER START [ID=0] ; error 22006 "SYN"
  #TIMER START SYN [ID=0]
  #TIMER READ ASYN [ID=0] ; error 22004 "ASYN"; error 22006 "SYN"
  #TIMER READ SYN [NR=0] ; error 22004 "NR"
  #TIMER LOOK SYN ; error 22004 "LOOK"
  #ERROR [ID=666 RC=2 PM1=1 PV1=99]
  #ERROR [ID=666 TEXT=1] ; error 22004 "TEXT"
  #ERROR [RC=0] ; error 21171 "#ERROR"
  #ERROR [ID=1001 RC=8 MID=0] ; error 21171 "1001"; error 21173 "8"; error 900462 "0"
  #ERROR [ID=1 ID=2 RC] ; error 21887 "ID"; error 900208 "RC"
  #ERROR [ID=1 PV1="23 characters are enough" PM1="text"] ; error 900281 "23"; error 21981 "text"
  #ERROR [ID=1 PV1=V.E.NONE] ; error 20196 "V.E.NONE"
#RT CYCLE END
; --- a block number inside a cycle
#RT CYCLE
  N[V.E.NONE] M100 ; error 20196 "V.E.NONE"
#RT CYCLE END
; --- functions of axes (manual 4.3)
#RT CYCLE [ID=1 SCOPE=PROG]
  $IF ONCE V.E.VALUE > 1
    X[M100] ; error 901004 "X[M100]"
    Y[H7] ; error 901004 "Y[H7]"
  $ENDIF
#RT CYCLE END
