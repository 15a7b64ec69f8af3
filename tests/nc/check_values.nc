; Expressions and accesses that are simulated
P1 = 3 * [V.E.VALUE + 2] ** 2 MOD 4
P[P1 + 1] = -P1
P2 = SQRT[2] + ATAN2[1, 2] - ROUND[PI] * TRUE
P3 += 1 P4 -= 2 P5 *= 3 P6 /= 4
V.E.VALUE = P1
V.E.LIST[0] = V.E.LIST[9]
V.E.LIST[P1] = V.E.LIST[P1 + 1]
V.E.LEVEL_1_A[2].REAL64 = 5
V.E.LEVEL_1_A[0].LEVEL_2_A[1].LIST[3] += 1
V.E.OUTPUT = V.E.INPUT
V.CH.Table[4] = V.CH.Level.UNS08
V.CH.VarTest1 = 2
Vs.CH.VarTest1 = Vs.CH.VarTest1 + 1
V.E.FLAG = V.E.VALUE > 3 && NOT V.E.FLAG
V.RTG.CYCLES.DIAG_LEVEL = 4
V.RTG.MEAS_DELTA = V.RTG.MEAS_DELTA + 1
P1 = V.RTG.TIMER[127] + V.RTG.OVERRIDE.VEL.TOTAL
P1 = V.RTA.ACS.ACT_POS.X + V.RTA.MCS.DIST_TO_GO.A
V.E.VALUE
Vs.E.LEVEL_1_A[0].REAL64
P1
$IF V.E.VALUE > 1 || P1
  G00 X1
$ELSEIF INT[P1]
$ELSE
$ENDIF
$FOR P1 = 0, V.E.VALUE, 1
  $BREAK
$ENDFOR
$FOR V.E.VALUE = 10, 0, -1
  $CONTINUE
$ENDFOR
$SWITCH P1
$CASE 1
  $BREAK
$DEFAULT
$ENDSWITCH
M30
; --- names
V.E.VALUES = 1 ; error 20196 "V.E.VALUES"
V.E.value = 1 ; error 20196 "V.E.value"
P1 = V.CH.Nothing ; error 20196 "V.CH.Nothing"
P1 = V.E.LEVEL_1_A[0].REAL ; error 20196 "V.E.LEVEL_1_A[].REAL"
P1 = V.RTG.NOTHING ; error 20196 "V.RTG.NOTHING"
P1 = V.RTA.ACS.ACT_POS.Q ; error 901003 "V.RTA.ACS.ACT_POS.Q: this channel has no axis Q"
P1 = V.RTA.ACS.ACT_POS ; error 20196 "V.RTA.ACS.ACT_POS"
P1 = V.RTG.PATH.SPEED ; error 20196 "V.RTG.PATH.SPEED"
P1 = V.CHAN.A ; error 20196 "V.CHAN.A"
P1 = V.E.NONE[V.E.NEITHER] ; error 20196 "V.E.NONE[]"; error 20196 "V.E.NEITHER"
XV.E.NONE ; error 20196 "V.E.NONE"
; --- families of later versions
P1 = V.G.NP[1].V.X + V.A.ABS.X + V.A.ACT_POS[0] + V.G.FEEDRATE
V.G.NP[1].V.X = 1 V.G.NP_AKT.V[0] += V.E.NONE ; error 20196 "V.E.NONE"
P1 = V.G.NP.V.X ; error 900200 "V.G.NP.V.X"
P1 = V.G.NP[1].ALL ; error 900200 "V.G.NP[].ALL"
P1 = V.G.NP[1][2].V.X ; error 900200 "V.G.NP"
P1 = V.A.ABS ; error 20196 "V.A.ABS"
P1 = V.A.ABS.Q ; error 901003 "V.A.ABS.Q: this channel has no axis Q"
P1 = V.A.ABS.S ; error 901003 "V.A.ABS.S: this channel has no axis S"
P1 = V.A.FOO.X ; error 900200 "V.A.FOO.X"
P1 = V.G.NP[3].V.Q ; error 901003 "V.G.NP[].V.Q: this channel has no axis Q"
P1 = V.SPDL_PROG.SPEED.X ; error 20196 "V.SPDL_PROG.SPEED.X"
P1 = V.G.MASS_MM[1] ; error 900200 "V.G.MASS_MM[]"
V.A.ABS.X = 1 ; error 20100 "V.A.ABS.X"
P1 = V.A.+SWE_MDS.Z
P1 = @P1
@P1 = 3
; --- indices
P1 = V.E.LIST ; error 21216 "wrong number of indices for V.E.LIST: 1 expected, 0 given"
P1 = V.E.VALUE[1] ; error 21768 "wrong number of indices for V.E.VALUE: 0 expected, 1 given"
V.E.LIST[1][2] = 1 ; error 20974 "wrong number of indices for V.E.LIST: 1 expected, 2 given"
V.E.LEVEL_1_A.REAL64 = 1 ; error 21216 "wrong number of indices for V.E.LEVEL_1_A: 1 expected, 0 given"
P1 = V.RTG.TIMER ; error 21216 "V.RTG.TIMER"
P1 = V.E.LIST[10] ; error 21928 "V.E.LIST[] has no element 10"
V.E.LIST[-1] = 1 ; error 21928 "-1"
V.E.LIST[9.6] = 1 ; error 21928 "element 10"
V.E.LIST[9.5] = 1 ; error 21928 "element 10"
V.E.LIST[8.5] = 1
P1 = V.RTG.TIMER[128] ; error 21928 "128"
V.E.LEVEL_1_A[3].LEVEL_2_A[2].LIST[4] = 1 ; error 21928 "3"; error 21928 "2"; error 21928 "4"
P1 = V.E.LIST[V.E.LIST[10]] ; error 21928 "10"
; --- structures and lists of values
P1 = V.E.LEVEL_1_A[0] ; error 900215 "V.E.LEVEL_1_A[] is a structure"
V.E.VALUE = V.E.LEVEL_1_A[0] + 1 ; error 900215 "V.E.LEVEL_1_A[]"
V.E.LEVEL_1_A[0].REAL64 = V.E.LEVEL_1_A[0] ; error 900215 "V.E.LEVEL_1_A[]"
V.E.LEVEL_1_A[0] = 5 ; error 900215 "V.E.LEVEL_1_A[]"
V.CH.Level = V.E.LEVEL_1_A[0]
V.E.LIST = [1, 2, 3] ; error 900200 "[1, 2]"
P1 = [1, 2]
P1 = 2 + [1, 2] ; error 900200 "[1, 2]"
; --- rights
V.E.INPUT = 1 ; error 20100 "V.E.INPUT is READ_ONLY"
V.E.INPUT += 1 ; error 20100 "V.E.INPUT is READ_ONLY"
P1 = V.E.OUTPUT ; error 20097 "V.E.OUTPUT is WRITE_ONLY"
V.E.OUTPUT += 1 ; error 20097 "V.E.OUTPUT is WRITE_ONLY"
V.E.OUTPUT ; error 20097 "V.E.OUTPUT is WRITE_ONLY"
V.RTG.OVERRIDE.VEL.CYCLE = 50 ; error 21993 "W access to V.RTG.OVERRIDE.VEL.CYCLE is not available here: program R, realtime cycle R/W"
V.RTG.OVERRIDE.VEL.TOTAL = 50 ; error 21993 "program R, realtime cycle R"
V.RTG.TIMER[1] = 0 ; error 21993 "V.RTG.TIMER[]"
V.RTA.ACS.ACT_POS.X = 0 ; error 21993 "V.RTA.ACS.ACT_POS.X"
$FOR V.E.INPUT = 1, 2, 1 ; error 20100 "V.E.INPUT"
$ENDFOR
$FOR V.E.OUTPUT = 1, 2, 1 ; error 20097 "V.E.OUTPUT"
$ENDFOR
; --- Vs. for the whole block
Vs.CH.VarTest1 = V.CH.VarTest1 + 1 ; error 900228 "V.CH.VarTest1"
V.E.ASYNC = Vs.E.ASYNC ; error 900228 "V.E.ASYNC"
XVs.E.ASYNC YV.E.ASYNC ; error 900228 "V.E.ASYNC"
V.E.VALUE = Vs.E.VALUE
#MSG ["%f %f", V.E.ASYNC, Vs.E.ASYNC] ; error 900228 "V.E.ASYNC"
; --- texts
V.E.TEXT = 1 ; error 21460 "1 is not a text"
P1 = V.E.TEXT ; error 21461 "V.E.TEXT holds a text"
P1 = "text" ; error 21461 "holds a text"
$IF V.E.TEXT == ""
$ENDIF
; --- functions and bare words
P1 = SINE[30] ; error 20392 "SINE"
P1 = FOO[V.E.NONE] ; error 20392 "FOO"; error 20196 "V.E.NONE"
P1 = SIN[1, 2] ; error 21474 "wrong number of arguments for SIN: 1 expected, 2 given"
P1 = ATAN2[1] ; error 21471 "wrong number of arguments for ATAN2: 2 expected, 1 given"
P1 = SIN ; error 20392 "SIN"
P1 = TRU ; error 20392 "TRU"
; --- structures of control
$GOTO N10 ; error 20840 "N10"
$GOTO [MARK] ; error 20840 "MARK"
$IF P1 $GOTO N20 ; error 20840 "N20"
$BREAK ; error 20243 "$BREAK"
$CONTINUE ; error 20244 "$CONTINUE"
$SWITCH V.E.NONE ; error 20196 "V.E.NONE"
$CASE V.E.NEITHER ; error 20196 "V.E.NEITHER"
  $CONTINUE ; error 20244 "$CONTINUE"
  G66 ; error 900200 "G66"
N[V.E.NONE] $CASE 2 ; error 20196 "V.E.NONE"
$ENDSWITCH
$IF ONCE P1 > 3 ; error 900222 "$IF ONCE"
$ELSEIF EDGE P1 > 2 ; error 900222 "$ELSEIF EDGE"
  V.E.NONE ; error 20196 "V.E.NONE"
$ELSE
  V.E.NONE ; error 20196 "V.E.NONE"
$ENDIF
$WHILE V.E.NONE ; error 20196 "V.E.NONE"
  G66 ; error 900200 "G66"
$ENDWHILE
$DO
  G66 ; error 900200 "G66"
$ENDDO V.E.NONE ; error 20196 "V.E.NONE"
$REPEAT
  $BREAK
$UNTIL V.E.NONE ; error 20196 "V.E.NONE"
$FOR P1 = V.E.NONE, V.E.NEITHER, V.E.NOR ; error 20196 "NONE"; error 20196 "NEITHER"; error 20196 "NOR"
$ENDFOR
$FOR @P1 = 1, 2, 1
$ENDFOR
#IF P1 > 3
G66 ; error 900200 "G66"
#ENDIF
; --- what never runs is not checked
$IF 0
  G66 ::
$ELSEIF FALSE
  G66
$ELSE
  G66 ; error 900200 "G66"
$ENDIF
$WHILE 0
  V.E.NONE
$ENDWHILE
; --- # commands
#FLUSH NOW ; error 900233 "#FLUSH"
#TIME ; error 900233 "#TIME"
#TIME V.E.NONE ; error 20196 "V.E.NONE"
#MSG ; error 900233 "#MSG"
#TIMER START [ID=1]
#ERROR [ID=1 RC=0]
#ERROR [ID=1 TEXT=1 RC=0.5] ; error 21220 "TEXT"; error 21173 "0.5"
#CHANNEL INIT [CMDPOS]
#KIN ID[9]
#TRAFO ON [1] ; error 900233 "#TRAFO"
#SLOPE [TYPE=SIN2] ; note 901551 "#SLOPE [TYPE=SIN2]"
#MC_MovePath SYN [CH=1] ; error 900200 "#MC_MOVEPATH SYN"
#FLUHS WAIT ; error 20509 "#FLUHS"
#XYZ ; error 20509 "#XYZ"
#RT CYLCE ; error 20509 "#RT CYLCE"
; --- messages
#MSG ["plain"]
#MSG SAVE EXCLUSIVE ["%d %5.2f %s %%", 1, P1, "text"]
#MSG SAVE ["%i %u %x %X %o %c %e %E %g %G %+08.3f", 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11]
#MSG ["V.RTG.TIMER[%d] = %f", P1, V.RTG.TIMER[P1]]
#MSG ["%d"] ; error 20721 "placeholders in the text: 1, values given: 0"
#MSG ["text", 1] ; error 20721 "placeholders in the text: 0, values given: 1"
#MSG ["%d %y", 1, 2] ; error 21180 "%y"
#MSG ["100 %"] ; error 21180 "%"
#MSG ["%s", P1]
#MSG ["%F %#x", 1, 2] ; error 21180 "%F"
#MSG ["%1000d", 1] ; error 21180 "%1000d"
#MSG ["%d", "text"] ; error 900232 "%d"
#MSG ["%f", V.E.NONE] ; error 20196 "V.E.NONE"
#MSG ["%s", V.E.TEXT]
#MSG ["%d", V.E.TEXT] ; error 900232 "%d"
#MSG [V.E.TEXT]
#MSG [V.P.T + "%d", P1]
#MSG [P1] ; error 21460 "P1"
#MSG [V.E.TEXT, V.E.NONE] ; error 20196 "V.E.NONE"
#MSG SAFE ["x"] ; error 21220 "SAFE"
#MSG SAVE SAVE ["x"] ; error 21710 "SAVE"
#MSG SAVE CONTINUE ["x"]
#MSG INFO ["x"] ; error 900200 "#MSG INFO"
; --- variables of a program's own
#VAR
  V.L.A
  V.L.B : UNS32 = 200
  V.P.C[2][3] = [1, 2, 3, 4, 5, 6]
  V.S.D : STRING[20] = "text"
  V.CYC.E[P1] : STRING[P2]
  V.P.GROUP[2].POS[3] : REAL
  V.L.F : INT ; error 900136 "unknown type INT"
  V.L.G[0] ; error 20917 "V.L.G[] cannot have 0 elements"
  V.L.H[1][2][3][4][5] ; error 20974 "more than 4 indices"
  V.E.VALUE = 3 ; error 20908 "V.E.VALUE is not a variable that programs can create"
  V.L.I = V.E.NONE ; error 20196 "V.E.NONE"
#ENDVAR
V.P.X = 1
V.P.X += V.L.A * 2
V.P.T = "text" + V.S.D
V.P.T -= "text" ; error 21458 "-"
XV.P.X Y[V.P.C[1][P1]]
V.P.C = [1, [2, V.L.A], "text"]
V.E.LIST = [1, 2] ; error 900200 "values of a list"
$IF V.P.T == "text" && V.P.X == 1 && "text" != V.P.T + "more"
$ENDIF
#MSG ["%s %d", V.P.T, V.P.X]
#DELETE V.P.X, V.S.D
#DELETE V.P.
#DELETE ; error 900233 "#DELETE"
#DELETE V.E.VALUE ; error 20908 "V.E.VALUE"
#RT CYCLE
  V.E.VALUE = V.P.X + V.L.B
  V.P.X = 1 ; error 22009 "V.P.X"
#RT CYCLE END
; --- functions of names and texts
P1 = EXIST[V.P.NONE] + EXIST[@P1] + EXIST[M100] + EXIST[V.E.NONE[P1]]
P1 = EXIST[V.E.NONE[V.E.NONE]] ; error 20196 "V.E.NONE"
P1 = EXIST[5] ; error 20868 "5 cannot be queried"
P1 = EXIST[COLOUR] ; error 20868 "COLOUR"
P1 = SIZEOF[V.E.LIST] + SIZEOF[V.P.A, 2] + IS_STRING["text"] + IS_NUMBER[P1]
P1 = LEN["text"] + FIND["text", "x"] + ORD["A"] + STR_TO_REAL["1"] + STR_TO_INT[V.P.T]
V.E.TEXT = LEFT["text", 2] + RIGHT["text", 1] + MID["text", 1, 2] + REAL_TO_STR[3]
V.E.TEXT = INSERT["text", "x", 1] + DELETE["text", 1, 1] + REPLACE["text", "x", 1, 1]
P1 = LEN[5] ; error 21460 "5"
P1 = LEFT["text", 2] ; error 21461 "LEFT"
P1 = LEN["text", 2] ; error 21474 "wrong number of arguments for LEN: 1 expected, 2 given"
#RT CYCLE
  V.E.VALUE = LEN["text"] ; error 900220 "LEN"
#RT CYCLE END
; --- commands of the program
#TIMER START
#TIMER READ SYN [ID=P1]
#TIMER READ [ID10]
#TIMER CLEAR [ID=V.E.NONE] ; error 20196 "V.E.NONE"
#TIMER PAUSE ; error 21220 "#TIMER has no option PAUSE"
#TIMER START ASYN [NR=1] ; error 21220 "ASYN" ; error 21220 "NR"
P1 = V.G.TIMER[P1] + V.G.WZ_AKT.R + V.A.+SWE_MDS.X - V.A.-SWE_MDS.X
P1 = V.G.TIMER ; error 900200 "V.G.TIMER"
V.G.TIMER[1] = 5 ; error 20100 "V.G.TIMER[]"
P1 = V.A.+SWE_MDS.Q ; error 901003 "V.A.+SWE_MDS.Q"
#FILENAME [MSG="report.txt"]
#FILE NAME [MSG=report.txt]
#FILENAME ; error 900233 "#FILENAME"
#FILENAME [LOG=report.txt] ; error 21220 "LOG"
#FILENAME [MSG=5] ; error 21460 "5"
#CHANNEL INIT
#CHANNEL INIT [CMDPOS]
#CHANNEL INIT [POS] ; error 21220 "POS"
#MSG SAVE EXCLUSIVE CONTINUE ["text"]
#RT CYCLE
  V.E.VALUE = V.G.TIMER[3]
#RT CYCLE END
