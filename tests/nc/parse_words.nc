; Words without blanks, with blanks, with and without =
N10G1X1.5Y-2F100
n20 g01 x1. y-.5 z+.5 f100
X 52525.00
X=1 Y = -2
X1=10 XR=5 A1 = 0 C20
XV.L.X YVs.E.Y[2].Z
XP1 YP2 ZP[P1+2]
X[P1+2] Y [2*3]
X SIN [P1*5] YCOS[30] ZATAN2[1,2]
X P1 Y V.P.A
X-P1 Y+V.L.B
AP20 BP10+P20 U10 V20 W1
G02 XP10+P20
TV.P.NR
M6 T5 D3 H12
M110=130
M@P6
LM06
G805[1, P2, V.L.C]
G129 = 50
G04 3.0
G04 P1
G04 X4.5
G4 S10
S1000 M3
S=2000 S.POS100 S.POS = 45
S2[M03 REV=1000]
S2 [M05]
S2[M03 M19 REV1000 POS314]
Z[DIST_CTRL OFF NO_MOVE]
Z [INDP ABORTING G01 G90 FEED=500 POS=900 OFFSET=ALL]
Z[INDP DIR = POS FEED = 1000]
Z[INDP DIR = 2*P1-1 FEED1000]
X[INDP STOP]
X[INDP G0 G90 POS = 137 ]
M17 [MAIN]
M17[JUMPS=2]
"MACRO"
"DRILL" = "G1 Z-10"
P1=5 P2 = 6 X10
G04 P1 = 3
X[@P1 = 3]
G0 X10 P1 += 2
@P1 = 3
P[P1+1] = 4
V.L.A[1][P2].B = V.G.NP[1].V.X * 2
V.A.+SWE_MDS.Z = 3
V.L.T = "a" + "b"
V.L.A = [1, 2, [3, 4]]
V.E.S -= 1
V.E.S *= 2
V.E.S /= 2
Vs.E.A
V.P.ARRAY[3][6]
P7
/ G0 X1
/10 N5 G0 X1
N100
NP1 G0 X1
N[P1*10] G0 X2
unknown words here
; --- the block number stands in front of a skip level only
/0 X1 ; error 21655 "0"
/11 X1 ; error 21655 "11"
N10 /2 X1 ; error 20797 "/"
; --- calls
L file
L sub.nc
L dir/sub.nc G0 X1
L C:\dir\sub.nc
L "with blank.nc"
L V.P.NAME
LL UP1
LL UP1 ( comment )
N10 LL UP2 G0 X1
L CYCLE [NAME=drill.cyc @P1=2.5 @P2 = V.L.A @P3="text" @P4=-3-4]
LL CYCLE[NAME = UP1 \
  @P1 = V.L.A \

  ; @P2 = V.L.B \
  N20 @P3 = V.L.C \
  ]
L CYCLE [NAME="a b.cyc"]
L CYCLE [NAME=C:\dir\a.cyc @P1=1]
LL cycle
; --- calls with mistakes
L CYCLE [@P1=3] ; error 900916 "NAME"
L CYCLE [NAM=a.nc] ; error 900133 "NAM"
L CYCLE [NAME=a.nc @P1=3 ; error 20397 "bracket"
L CYCLE [NAME=] ; error 900114 "]"
L CYCLE [NAME=a @P] ; error 900101 "@"
; --- # commands
#FLUSH
#FLUSH WAIT
#FLUSH CONTINUE
#TIME 1.5
#TIME P1 * 2
#TIME [P1 + 1] * 2
#TIME [3]
#TIMER START SYN [ID = 0]
#TIMER READ
#MSG ["text"]
#MSG SAVE EXCLUSIVE ["V.RTG.TIMER[%d] = %f", P1, V.RTG.TIMER[P1]]
#MSG["Text: %s",@P1]
#ERROR [ID=666 RC=2 PM1=1 PV1=99]
#FILENAME [MSG=out/report.txt]
#CHANNEL INIT [CMDPOS]
#CS DEF [1] [0, 0, 0, 0, 0, 45]
#CS ON
#KIN ID[12]
#TRAFO OFF
#CONTOUR MODE [DEV PATH_DEV 0.5 TRACK_DEV=10]
#SLOPE [TYPE=STEP]
#DELETE V.P.A, V.P.B[1]
#INIT V.E.
#MC_MovePath SYN [ CH=1 @PL1=V.P.A @PL2=V.P.B ]
#WAIT SYN [ID1 CH2]
#IDENT RD [AX=X ID=P-AXIS TYP=UNS32 P=P1]
# FLUSH WAIT
; --- # commands with mistakes
# ; error 900114 "the end of the block"
#3 ; error 900114 "3"
#MSG ["text] ; error 20790 "quote"
#MSG ["text" ; error 20397 "bracket"
#FLUSH ] ; error 900103 "']'"
#CS ON [1, ::] ; error 20797 ":"
; --- words with mistakes
G0 X10 ] ; error 900103 "']'"
G0 X[1+2 ; error 20397 "bracket"
G0 X= ; error 900101 "the end of the block"
G0 X- ; error 900101 "the end of the block"
G0 X=foo ; error 900101 "foo"
G0 X1.2.3 ; error 20797 "."
G0 X "text ; error 20790 "quote"
"text ; error 20790 "quote"
"A" = 5 ; error 900101 "5"
X10 , Y10 ; error 20797 ","
X10 % comment ; error 20797 "%"
X10 $IF 1 ; error 20797 "$"
X10 #FLUSH ; error 20797 "#"
V.E.A + 5 ; error 20797 "+"
V.E. = 5 ; error 900114 "="
V.E.A[ = 5 ; error 900101 "="
V.E.A[1 = 5 ; error 20716 "']'"
V. ; error 900114 "the end of the block"
P[1,2] = 3 ; error 20797 "["
P1 = ; error 900101 "the end of the block"
P1 = 1 +* 2 ; error 900101 "*"
P1 = [1 + 2 ; error 20397 "bracket"
P1 = SIN[] ; error 900101 "]"
P1 = SIN[30 40] ; error 20716 "']'"
P1 = 1 2 ; error 20797 "2"
X[INDP G90 POS=] ; error 900101 "]"
S2[M03 REV=1000 ; error 20397 "bracket"
