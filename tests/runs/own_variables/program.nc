%L INNER
#VAR
  V.L.A = 20
#ENDVAR
#MSG ["inner %g %g %g", V.L.A, V.L.B, V.P.COUNT]
V.L.B += 1
V.P.COUNT += 1
M17
%L CYC
#VAR
  V.CYC.SUM : REAL64 = @P1 + 1
#ENDVAR
#MSG ["cycle %g", V.CYC.SUM]
M17
%MAIN
#VAR
  V.L.A = 10          ; REAL64
  V.L.B               ; REAL64, 0
  V.L.WORD : STRING[12] = "PLATE"
  V.P.SMALL : UNS08 = 200
  V.P.FLAG : BOOLEAN = 7
  V.P.FIELD[2][3] = [11, 12, 13,
  21, 22, 23]
  V.S.KEPT[2] = [1.5, 2.5]
#ENDVAR
V.P.COUNT = 1
LL INNER
#MSG ["outer %g %g %g", V.L.A, V.L.B, V.P.COUNT]
#MSG ["%g %g %g", V.P.FIELD[1][2], SIZEOF[V.P.FIELD], SIZEOF[V.P.FIELD, 2]]
V.P.SMALL -= 0.5
#MSG ["%g %g", V.P.SMALL, V.P.FLAG]
V.P.FIELD = [1, 2]
P1 = 1
#MSG ["%g %g", V.P.FIELD[0][P1], V.P.FIELD[P1][0]]
LL CYCLE [NAME=CYC @P1=4]
#MSG ["%g %g %g", EXIST[V.P.NONE], EXIST[V.S.KEPT[2]], EXIST[M100]]
V.L.WORD = LEFT[V.L.WORD, 3] + "N" + REAL_TO_STR[0.5]
#MSG ["%s %d %d", V.L.WORD, LEN[V.L.WORD], FIND[V.L.WORD, "N0"]]
#MSG ["%s", MID["How are you?", 3, 5] + RIGHT["Hello", 2] + INSERT["AD", "BC", 1]]
#MSG ["%s %g", DELETE["ABXC", 1, 3] + REPLACE["ABC", "x", 1, 2], STR_TO_REAL["2.5"] + ORD["A"]]
$IF V.L.WORD == "PLAN0.500000" && NOT[IS_NUMBER[V.L.WORD]]
  #MSG ["equal"]
$ENDIF
#DELETE V.P.COUNT
#MSG ["%g", EXIST[V.P.COUNT]]
G00 XV.P.FIELD[1][1]
#RT CYCLE [SCOPE=PROG]
  V.E.VALUE = V.S.KEPT[1]
#RT CYCLE END
V.S.KEPT[1] = 9
#TIME 0.002
M30
