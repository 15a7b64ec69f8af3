; All of it is simulated
%MAIN
N10 G00 X1 Y2.5 Z-3 A90
N20 G01 G90 G71 X[1+2] F500
G91 G70 X1
G01 X1 F1000 M100 M111 M112 M113 M117 M118 H100
M110=130 H100 = -P1
M[P1 + 1] MP1=-2 H=P1 G[P1]
M@P6
/ G00 X0
/3 N30 G00 X0
N100
N40: G00 X1
[MARK] G00 X2
P1 = 5 P2 = 6 X10
G00 XP1 YV.E.VALUE
G04 X0.5
G04 0.5
G4 P1
N5 G04 X[2 * P1]
#TIME 0.5
#FLUSH
#FLUSH WAIT
#FLUSH CONTINUE
F100
M30
; --- the path: planes, arcs, ends of blocks
G17 G02 X1 Y1 I1 J0
G18 G3 X1 Z1 R5
G19 G161 G60 X3
G61 G162 X1
G261
G360
G260
G359
; --- accepted: told once per program
G17 G164 X1 ; note 900201 "G164"
G17 G164 X2
G94
G97
G165 ; note 900201 "G165"
M02
; --- refused by name
G200 Z1 ; error 900200 "G200 (manual mode)"
G08 X1
G09 X1
G41 G42 X1 ; error 20114 "G42"
G25 G26 ; error 20113 "G26"
G138 G139 ; error 20126 "G139"
G107 G108 ; error 900210 "G108"
G236 ; error 900200 "G236"
G80 ; error 20131 "G80"
G805[1, P2] ; error 20131 "G805"
G839 ; error 20131 "G839"
G840 ; error 20131 "G840"
G129 = 50
G160 X1 ; error 900200 "G160"
G163 ; error 900927 "G163"
G163=V.E.NONE ; error 20196 "V.E.NONE"
G163=5 G02 X1 I1 ; error 21024 "a centre and a radius"
S1000
S2=2000 ; error 21035 "S2=2000"
S.POS=90 ; error 900902 "M19"
S2[M03 REV=1000]
S2[M19 POS=90] M3 S100 X1
S2[M03 FEED=1000] ; error 21035 "FEED"
S2[M03 REV=1000 REV=2000] ; error 21887 "REV"
S2[] ; error 50954 "S2[]"
S1000 S ; error 21035 "S"
M3
M3 M4 ; error 20155 "M3, M4"
M5 M19 ; error 21151 "M5, M19"
M3=4 S100 ; error 21035 "M3=4"
M3 S=V.E.NONE ; error 20196 "V.E.NONE"
M19
T1 D2 ; note 900201 "T (tool"
D ; error 900208 "D"
E100
X[INDP G90 POS=10] ; error 900260 "X[INDP …]"
Z[DIST_CTRL OFF] ; error 900200 "Z[DIST_CTRL …]"
M110=2147483648 ; error 21494 "M110=2147483648"
M110=V.E.NONE ; error 20196 "V.E.NONE"
M[V.E.NONE]=V.E.NONE ; error 20196 "V.E.NONE"; error 20196 "V.E.NONE"
M[SAVE] ; error 20797 "M[SAVE]"
M114
M115
M116
H116
M200
H200
G04 S10
G04 S10 X1 ; error 21785 "G04"
M30
; --- nobody knows it
Q5 ; error 20797 "Q5"
X Y1 ; error 900208 "X"
B10 X1 ; error 20797 "B10"
XR=5 ; error 20797 "XR=5"
X1=10 ; error 20797 "X1=10"
UNKNOWN words in a line ; error 20797 "UNKNOWN"
O100 ; error 20797 "O100"
Q[INDP G90 POS=10] ; error 20797 "Q"
S7[M05] ; error 20797 "S7"
G7 ; error 20131 "G7"
G54.1 ; error 20107 "G54.1"
G-1 ; error 20107 "G-1"
M1.5 ; error 20154 "M1.5"
M99 ; error 20157 "M99"
M46 T5 ; error 20157 "M46"; note 900201 "T (tool"
H70 ; error 20162 "H70"
; --- words without a value
G ; error 900208 "G"
M ; error 900208 "M"
G01 X1 F ; error 900208 "F"
; --- together in one block
G00 G01 X1 ; error 20108 "G01 and G00"
G01 G02 X1 ; error 20108 "G02 and G01"
G260 G261 X1 ; error 20117 "G261 and G260"
G90 G91 X1 ; error 20120 "G91 and G90"
G70 G71 ; error 20118 "G71 and G70"
G90 X1 G90 ; error 20120 "G90 is given twice"
G60 G261 X1 ; error 20117 "G261 and G60"
G261 G360 ; error 20117 "G360 and G261"
G1.5 ; error 20107 "G1.5"
G70000 ; error 20107 "G70000"
G777 ; error 20131 "G777"
G17 G18 ; error 20111 "G18 and G17"
G90 G90 X1 ; error 20120 "G90"
X1 Y2 X3 ; error 20203 "X"
F1 F2 X1 ; error 20175 "F"
G00 5 X1 ; error 900212 "G00"
M100 M100 M101
G60 ; error 20003 "G60"
G60 F100 ; error 20003 "G60"
; --- G04 alone
G04 ; error 21786 "without"
G04 X1 Y1 ; error 20685 "alone"
G04 X1 M100 ; error 20685 "alone"
G04 X ; error 20685 "alone"
G04 1 X1 ; error 21785 "more than one"
G04 F5 ; error 20685 "alone"
G00 G04 X1 ; error 20685 "alone"
G04 S1 X1 ; error 21785 "more than one"
G04 X[V.E.UNKNOWN] ; error 20196 "V.E.UNKNOWN"
; --- behind the end nothing is checked, but subprograms are
%L SUB
G00 X1
G66 ; error 900200 "G66"
M17
G66
%MAIN
G00 X1
M30
G66
; --- a skipped end ends nothing
/ M30
G66 ; error 900200 "G66"
M30
; --- block numbers are values
N[P1*10] G0 X1
N[V.E.NONE] G0 X1 ; error 20196 "V.E.NONE"
; --- ends and returns of subprograms
%L SUB
M17 [MAIN]
%L OTHER
$IF P1
  M29
  M17 [JUMPS=2 N20]
  M17 [JUMPS=P1 [MARK]]
  M17 [MARK]
  M17 N20
  M17 [JUMPS] ; error 900135 "JUMPS is not a valid option of a return"
  M17 [MAIN JUMPS=2] ; error 900135 "JUMPS"
  M17 [5] ; error 900135 "5"
  M30 ; error 20377 "M30 ends a main program, but this is a subprogram"
$ENDIF
M17
what follows the end is not checked
%L SUB ; error 900130 "the local subprogram SUB is already defined in line 1"
M17
%MAIN
M17 ; error 20376 "M17 ends a subprogram, but this is the main program"
M29 [MAIN] ; error 20376 "M29"
M30
; --- calls
%L SUB
M17
%MAIN
L file.nc
L "folder\file name.nc"
L V.E.TEXT
L CYCLE [NAME=file.nc @P1="text" @P200=[1+P2]]
LL SUB
G00 X1 LL SUB
LL SAB ; error 20373 "no local subprogram SAB"
LL CYCLE [NAME=SUB @P1=V.E.NONE] ; error 20196 "V.E.NONE"
LL CYCLE [NAME=SUB @P1=1 @P1=2] ; error 21379 "@P1"
LL CYCLE [NAME=SUB @P201=1] ; error 900133 "@P201"
LL CYCLE [NAME=SUB @P1] ; error 900133 "@P1"
LL CYCLE [NAME=SUB COLOUR=1] ; error 900133 "COLOUR is not a parameter of a call"
LL CYCLE [NAME=SUB MODAL_MOVE @P1=1]
LL CYCLE [NAME=SUB MODAL MODAL_BLOCK] ; error 21379 "MODAL_BLOCK"
LL CYCLE [NAME=SUB MODAL_MOVE=1] ; error 900133 "MODAL_MOVE"
#DISABLE MODAL CYCLE
#DISABLE MODAL CYCLE [1] ; error 900233 "#DISABLE MODAL CYCLE"
$IF 0
  LL NOWHERE
$ENDIF
M30
; --- jumps
N10: G00 X1
$GOTO N10
$GOTO N010
$GOTO [MARK]
$GOTO N40 ; error 20840 "this program has no label N40"
$IF P1 $GOTO [mark]
$IF 0
  [DEAD] X2 Q3 ; error 20797 "Q3"
$ENDIF
$WHILE P1
  [INSIDE] G00 X3
  $GOTO [INSIDE] ; error 21480 "the label INSIDE is in a loop: it is not possible to jump there"
  $GOTO [MARK]
$ENDWHILE
N30: X1
N30: X2
$GOTO N30 ; error 20836 "the label N30 is defined twice in this program"
$IF 1
  [MARK] X4
$ENDIF
$GOTO [BEHIND]
M30
Q1
[BEHIND] Q2 ; error 20797 "Q2"
Q3 ; error 20797 "Q3"
; --- conditions of preprocessing
#IF P1 == 1
  Q1 ; error 20797 "Q1"
#ELSE
  G00 X1
#ENDIF
/#IF 0
  Q1
#ENDIF
N10 #IF 1 ; error 20593 "there must be no block number before #IF"
#ENDIF
; --- offsets (MO-8)
G54 X10
G159 = P1 Y3
G54 G55 ; error 20116 "G55 and G54"
G159 ; error 20147 "G159"
G159 = 97 ; error 20149 "97"
G159 = 96
G54 = 3 ; error 900212 "G54"
G92 X10 YP2
G92 ; error 20052 "G92 names no axis"
G92 G01 X5 ; error 900772 "G01 is not allowed with G92, whose values are not a motion"
#PSET X20 Y[P1 + 2]
#PSET ; error 20052 "#PSET names no axis"
#PSET X20 M100 ; error 900772 "M100"
#PSET X ; error 900208 "X"
#PRESET
#PRESET X0
#PRESET [ZERO] ; error 20873 "ZERO"
#SUPPRESS OFFSETS X50 Y100
N10 #SUPPRESS OFFSETS [ZERO TOOL] G01 X5 F100
#SUPPRESS OFFSETS [ZERO, TOLL] X5 ; error 20873 "TOLL is not a kind of offset"
#SUPPRESS OFFSETS ; error 20052 "#SUPPRESS OFFSETS names no axis"
#SUPPRESS OFFSETS [ZERO] ; error 20052 "names no axis"
; --- macros are read when they are used
"MACRO"
"DRILL" = "G1 Z-10 what is this"
G00 "DRILL" X1
T5 ; note 900201 "T (tool"
TV.E.NONE ; error 20196 "V.E.NONE"
; --- feeds and overrides (MO-4, MO-5)
G93 F2 G01 X5
G95 F0.1 X6 G166
G94 G95 ; error 20121 "G95 and G94"
G194 F50
G194 G94 ; error 20121 "G94"
G167 ; error 900233 "G167"
G167 S1
S2[G167 G167] ; error 21887 "G"
#OVERRIDE [FEED_FACT=50 RAPID_FACT=P1]
N10 #OVERRIDE [FEED_FACT=100]
#OVERRIDE ; error 900233 "OVERRIDE"
#OVERRIDE [FEED=50] ; error 21220 "FEED"
#OVERRIDE [Q=50] ; error 900706 "Q"
#OVERRIDE [] ; error 900233 "#OVERRIDE"
#OVERRIDE [FEED_FACT] ; error 900208 "FEED_FACT"
#SLOPE [] ; error 900233 "#SLOPE"
X[OVERRIDE FEED_FACT=20 RAPID_FACT=60]
X[OVERRIDE] ; error 900233 "OVERRIDE"
X[OVERRIDE RAPID_FACT] ; error 900208 "RAPID_FACT"
X[FIXED_STOP] ; error 900233 "FIXED_STOP"
X[OVERRIDE FEED_FACT=20 SLOW] ; error 900706 "SLOW"
Q[OVERRIDE FEED_FACT=20] ; error 20797 "Q["
X[OVERRIDE FEED_FACT=V.E.NONE] ; error 20196 "V.E.NONE"
; --- arcs with a centre and a radius
G02 X10 I5 R5 F100 ; error 21024 "a centre and a radius"
G03 X10 I5
G03 X10 R5
R7
M30
; --- #CONTOUR MODE and #SLOPE: misspelt, wrong, not simulated
#CONTOUR MODE ON [DEVV PATH_DEV=0.1] ; error 21220 "#CONTOUR MODE ON has no keyword DEVV"
#CONTOUR MODE [DEV PATH_DEF=0.1] ; error 21220 "#CONTOUR MODE has no keyword PATH_DEF"
#CONTOUR MODE [DEV PATH_DEV=0] ; error 21401 "the deviation 0 for contouring must be above 0"
#CONTOUR MODE [DEV PATH_DEV=-0.5] ; error 21401 "the deviation -0.5 for contouring must be above 0"
#CONTOUR MODE [DEV PATH_DEV=P1]
#CONTOUR MODE [QQ] ; error 900706 "QQ of #CONTOUR MODE"
#CONTOUR MODE ON DEV ; error 900233 "#CONTOUR MODE"
#SLOPE [TYP=STEP] ; error 21220 "#SLOPE has no keyword TYP"
#SLOPE [TYPE=TRAPEZZ] ; error 21220 "#SLOPE [TYPE] has no keyword TRAPEZZ"
#SLOPE ; error 900233 "#SLOPE"
M30
; --- #ERROR without its equals signs: one mistake each
#ERROR [ID 455] ; error 900208 "ID"
#ERROR [ID=455 RC 2] ; error 900208 "RC"
M30
; --- coordinate systems (MO-8)
#BACKWARD STORAGE CLEAR [1] ; error 900233 "BACKWARD"
#CS DEF [1] [0, 0, 10, P1, 0, 45]
#CS ON [,,10,,,45]
#CS ON [V.E.NONE, 0] ; error 20196 "V.E.NONE"
#CS ON
#CS OFF
#CS OFF ALL
#CS OFF [1] ; error 900233 "CS"
#CS DEF [1] ; error 900233 "CS"
#CS ON [1, 2, 3, 4, 5, 6, 7] ; error 900233 "CS"
#CS ON [ID=1] ; error 900233 "CS"
#CS ; error 900233 "CS"
#CS ADD [1, 2] ; error 900233 "#CS ADD"
#CS MODE ON ; error 900233 "#CS MODE ON"
#CS MODE ON [ROTATION_MODE_FIXED]
#CS MODE ON [ROTATION_SEQUENCE=XYZ] ; error 900706 "ROTATION_SEQUENCE"
#ACS ON [1] [0, 0, 10]
#ACS ADD [A] [1] ; error 900233 "#ACS"
#BCS OFF ALL
#MAIN SPINDLE [S2]
#MAIN SPINDLE [S9] ; error 21306 "S9"
#MAIN SPINDLE
