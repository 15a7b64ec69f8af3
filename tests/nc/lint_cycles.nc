; What is meant as it stands: nothing is found
#RT CYCLE [ID=1 SCOPE=PROG]
  $IF ONCE V.RTA.ACS.ACT_POS.X > 200
    M100
  $ENDIF
  $IF ONCE 1
    V.E.COUNT = 0
  $ENDIF
  $IF EDGE V.E.TRIGGER == 1
    M101 H100
  $ENDIF
  $IF V.E.VALUE > 5
    V.RTG.OVERRIDE.VEL.CYCLE = 75
    V.E.COUNT = V.E.COUNT + 1
    V.E.TIME += 0.001
  $ENDIF
  $IF ALWAYS V.E.VALUE > 7
    V.RTA.OVERRIDE.VEL.CYCLE.X = 50
    $IF EDGE V.E.TRIGGER
      M102
    $ENDIF
  $ENDIF
  $IF V.E.CONDITION == 1
    M103
    V.E.CONDITION = 0
  $ENDIF
#RT CYCLE END
M30
; --- asynchronous variables (RC-302)
P1 = 5
P2 = V.E.VALUE
#RT CYCLE
  $IF V.E.ASYNC == V.E.VALUE ; warning 900235 "V.E.ASYNC is asynchronous: in every tick this condition sees the value"
    V.E.COUNT = V.E.ASYNC
  $ENDIF
  $IF V.E.VALUE > P1 ; note 900236 "P1 is read once: in every tick the realtime cycle sees 5, set in line 1"
    V.E.COUNT = P2 ; note 900236 "P2 is read once: in every tick the realtime cycle sees the value that it has"
    V.E.COUNT = P2 + P1
  $ENDIF
  $IF ONCE V.CH.VarTest1 == 3 ; warning 900235 "V.CH.VarTest1 is asynchronous"
    Vs.CH.VarTest1 = 1
  $ENDIF
  $IF Vs.E.ASYNC == 1
    V.E.COUNT = 2
  $ENDIF
  V.E.LIST[P1] = V.E.LEVEL_1_A[1].FROZEN ; note 900236 "V.E.LEVEL_1_A[1].FROZEN"
#RT CYCLE END
#RT CYCLE
  $IF V.E.VALUE > P1 ; note 900236 "5, set in line 1"
    V.E.COUNT = 2 ; note 900244 "the realtime cycle in line 3 also writes V.E.COUNT"
  $ENDIF
#RT CYCLE END
; --- timers
#RT CYCLE
  #TIMER START SYN [ID=P1] ; note 900236 "P1"
  #TIMER READ SYN [ID]
#RT CYCLE END
; --- conditions that can never change
P1 = 5
P2 = 7
P[P1] = 3
#RT CYCLE
  $IF 1 ; warning 900237 "constant"
    V.E.COUNT += 1
  $ELSEIF SIN[30] > PI / 4 ; warning 900237 "constant"
    V.E.COUNT += 2
  $ENDIF
  $IF EDGE TRUE ; warning 900237 "constant"
  $ENDIF
  $IF ALWAYS P1 == 4 ; warning 900238 "of P1 it sees the value that it has"
  $ENDIF
  $IF P1 == 4 && V.E.ASYNC ; warning 900238 "of P1, V.E.ASYNC it sees the values that they have"
  $ENDIF
  $IF ONCE 0
  $ENDIF
  $IF ONCE P1 ; note 900236 "P1"
  $ENDIF
#RT CYCLE END
; --- types that decide a comparison
#RT CYCLE
  $IF V.E.FLAG == 2 ; warning 900239 "V.E.FLAG is of type BOOLEAN: this comparison is never true"
  $ENDIF
  $IF V.E.COUNT_POS >= 2147483648 ; warning 900239 "never true"
  $ENDIF
  $IF -2147483649 < V.E.COUNT_POS ; warning 900239 "always true"
  $ENDIF
  $IF V.E.COUNT_POS != 1.5 ; warning 900239 "always true"
  $ENDIF
  $IF V.E.COUNT_POS == -2147483648 || V.E.FLAG >= 1 || V.E.VALUE == 1.5
  $ENDIF
  $IF NOT[V.RTG.OVERRIDE.VEL.CYCLE < 0] ; warning 900239 "V.RTG.OVERRIDE.VEL.CYCLE is of type UNS16"
  $ENDIF
#RT CYCLE END
; --- positions compared exactly (RC-304)
#RT CYCLE
  $IF EDGE V.RTA.ACS.ACT_POS.X == 100 ; note 900248 "V.RTA.ACS.ACT_POS.X is compared for equality"
  $ENDIF
  $IF EDGE V.E.VALUE == V.RTA.ACS.CUR_POS.Y ; note 900248 "V.RTA.ACS.CUR_POS.Y"
  $ENDIF
  $IF EDGE V.RTA.ACS.ACT_POS.X == V.RTA.ACS.CMD_POS.X && V.RTA.PCS.DIST_TO_GO.X == 0
  $ENDIF
#RT CYCLE END
; --- one inside the other (RC-204)
#RT CYCLE
  $IF V.E.VALUE > 5
    $IF ONCE V.E.TRIGGER ; note 900240 "$IF ONCE inside $IF"
      $IF EDGE V.E.CONDITION ; warning 900241 "$IF ONCE"
      $ENDIF
      $IF V.E.CONDITION
        $IF ALWAYS V.E.COUNT ; warning 900241 "$IF ONCE"
        $ENDIF
      $ENDIF
    $ENDIF
  $ELSE
    $IF ALWAYS V.E.TRIGGER ; note 900240 "$IF ALWAYS"
      $IF EDGE V.E.CONDITION
        $IF ONCE V.E.COUNT ; note 900240 "$IF ONCE"
        $ENDIF
      $ENDIF
    $ENDIF
  $ENDIF
#RT CYCLE END
; --- overrides of one tick (RC-305)
#RT CYCLE
  $IF ONCE V.E.TRIGGER
    V.RTG.OVERRIDE.VEL.CYCLE = 75 ; warning 900242 "V.RTG.OVERRIDE.VEL.CYCLE is written inside $IF ONCE"
    $IF V.E.COUNT
      V.RTA.OVERRIDE.VEL.CYCLE.X = 75 ; warning 900242 "V.RTA.OVERRIDE.VEL.CYCLE.X is written inside $IF ONCE"
    $ENDIF
  $ENDIF
  $IF EDGE V.E.TRIGGER
    V.RTG.OVERRIDE.VEL.CYCLE = 75 ; warning 900242 "$IF EDGE"
    V.E.COUNT = 1
  $ENDIF
#RT CYCLE END
; --- M and H functions in each tick (RC-403)
#RT CYCLE
  M100 H101 ; warning 900243 "M100"
  $IF V.E.TRIGGER
    M101 ; warning 900243 "M101"
    V.E.COUNT = 1
  $ELSEIF V.E.COUNT == 1
    M102
    V.E.COUNT = 2
  $ELSE
    M103 ; warning 900243 "M103"
  $ENDIF
  $IF ALWAYS V.E.TRIGGER
    M104 ; warning 900243 "M104"
    $IF V.E.LIST[2] > 0
      M105
      V.E.LIST[2] = 0
    $ENDIF
    $IF V.E.LIST[2] > 0
      M106 ; warning 900243 "M106"
      V.E.LIST[1] = 0
    $ENDIF
  $ENDIF
#RT CYCLE END
; --- more than fits into a tick (RC-502, RC-503)
#RT CYCLE ; warning 900246 "may need 250 elementary instructions; P-CHAN-00427 allows 201" ; warning 900247 "time for 200"
  V.E.VALUE = V.E.BYTE*V.E.BYTE*V.E.BYTE*V.E.BYTE*V.E.BYTE*V.E.BYTE*V.E.BYTE*V.E.BYTE*V.E.BYTE*V.E.BYTE*V.E.BYTE*V.E.BYTE*V.E.BYTE*V.E.BYTE*V.E.BYTE*V.E.BYTE*V.E.BYTE*V.E.BYTE*V.E.BYTE*V.E.BYTE*V.E.BYTE*V.E.BYTE*V.E.BYTE*V.E.BYTE*V.E.BYTE
  V.E.VALUE = V.E.BYTE*V.E.BYTE*V.E.BYTE*V.E.BYTE*V.E.BYTE*V.E.BYTE*V.E.BYTE*V.E.BYTE*V.E.BYTE*V.E.BYTE*V.E.BYTE*V.E.BYTE*V.E.BYTE*V.E.BYTE*V.E.BYTE*V.E.BYTE*V.E.BYTE*V.E.BYTE*V.E.BYTE*V.E.BYTE*V.E.BYTE*V.E.BYTE*V.E.BYTE*V.E.BYTE*V.E.BYTE
  V.E.VALUE = V.E.BYTE*V.E.BYTE*V.E.BYTE*V.E.BYTE*V.E.BYTE*V.E.BYTE*V.E.BYTE*V.E.BYTE*V.E.BYTE*V.E.BYTE*V.E.BYTE*V.E.BYTE*V.E.BYTE*V.E.BYTE*V.E.BYTE*V.E.BYTE*V.E.BYTE*V.E.BYTE*V.E.BYTE*V.E.BYTE*V.E.BYTE*V.E.BYTE*V.E.BYTE*V.E.BYTE*V.E.BYTE
  V.E.VALUE = V.E.BYTE*V.E.BYTE*V.E.BYTE*V.E.BYTE*V.E.BYTE*V.E.BYTE*V.E.BYTE*V.E.BYTE*V.E.BYTE*V.E.BYTE*V.E.BYTE*V.E.BYTE*V.E.BYTE*V.E.BYTE*V.E.BYTE*V.E.BYTE*V.E.BYTE*V.E.BYTE*V.E.BYTE*V.E.BYTE*V.E.BYTE*V.E.BYTE*V.E.BYTE*V.E.BYTE*V.E.BYTE
  V.E.VALUE = V.E.BYTE*V.E.BYTE*V.E.BYTE*V.E.BYTE*V.E.BYTE*V.E.BYTE*V.E.BYTE*V.E.BYTE*V.E.BYTE*V.E.BYTE*V.E.BYTE*V.E.BYTE*V.E.BYTE*V.E.BYTE*V.E.BYTE*V.E.BYTE*V.E.BYTE*V.E.BYTE*V.E.BYTE*V.E.BYTE*V.E.BYTE*V.E.BYTE*V.E.BYTE*V.E.BYTE*V.E.BYTE
#RT CYCLE END
; --- single-axis commands in each tick (RC-405)
#RT CYCLE
  X[INDP G91 G00 POS=1] ; warning 900270 "X[INDP … G91]"
  Z[INDP BUFFERED G90 POS=V.E.ASYNC] ; warning 900270 "BUFFERED" ; note 900236 "V.E.ASYNC"
  Z[INDP G90 POS=1] A[INDP STOP] Z[INDP FEED=10]
  $IF EDGE V.E.TRIGGER
    X[INDP G91 G00 POS=1]
    Z[INDP BUFFERED G90 POS=2]
  $ENDIF
  $IF ALWAYS V.E.TRIGGER
    X[INDP G91 G00 POS=1] ; warning 900270 "X[INDP … G91]"
  $ENDIF
#RT CYCLE END
; --- keywords that the syntax allows and that have no effect (manual 4.5.1)
#RT CYCLE [ID=1 SCOPE=PROG]
  $IF ONCE V.E.VALUE > 1
    Z[INDP G00 G90 FEED=500 POS=10] ; note 901002 "FEED has no effect here: G00 moves at rapid speed"
    Z[INDP G90 POS=10 FEED=5 DIR=NEG] ; note 901002 "DIR has no effect here"
    Z[INDP G00 FEED=500] ; note 901002 "G00 has no effect here"
    Z[INDP G01 G90 FEED=500 POS=10]
    Z[INDP FEED=500 DIR=NEG]
  $ENDIF
#RT CYCLE END
; --- positions in inch (manual 4.5.3)
G70
#RT CYCLE [ID=1 SCOPE=PROG]
  $IF ONCE V.RTA.ACS.ACT_POS.X > 200 ; note 901001 "V.RTA.ACS.ACT_POS.X is in inches here"
    M100
  $ENDIF
  $IF ONCE V.RTA.ACS.ACT_POS.A > 200
    M100
  $ENDIF
#RT CYCLE END
G71
#RT CYCLE [ID=2 SCOPE=PROG]
  $IF ONCE V.RTA.ACS.ACT_POS.X > 200
    M100
  $ENDIF
#RT CYCLE END
; --- constants that are rounded (RC-307)
#RT CYCLE [ID=1 SCOPE=PROG]
  $IF V.E.VALUE > 5
    V.RTG.OVERRIDE.VEL.CYCLE = 0.5 ; warning 901050 "0.5 is rounded to 0"
    V.RTA.OVERRIDE.VEL.CYCLE.X = 50
    V.E.COUNT = 2.6 ; warning 901050 "V.E.COUNT is of type UNS32: 2.6 is rounded to 3"
    V.E.COUNT += 0.4 ; warning 901050 "0.4 is rounded to 0"
    V.E.COUNT = 5 / 2 ; warning 901050 "2.5 is rounded to 2"
    V.E.COUNT = 4 / 2 + 1
    V.E.COUNT = V.E.COUNT / 2
    V.E.TIME = 2.6
  $ENDIF
#RT CYCLE END
V.E.COUNT = 2.6 ; warning 901050 "2.6 is rounded to 3"
V.E.TIME = 2.6
P1 = 2.6
V.E.COUNT = 1 / 0 ; error 21241
; --- constants out of the range of their type (RC-307)
#RT CYCLE [ID=1 SCOPE=PROG]
  $IF V.E.VALUE > 5
    V.RTG.OVERRIDE.VEL.CYCLE = -1 ; error 50892 "-1 is outside the range 0 … 65535"
    V.RTG.OVERRIDE.VEL.CYCLE = 70000 ; error 50892 "70000"
    V.RTG.OVERRIDE.VEL.CYCLE = 65535
    V.E.COUNT = 5 - 6 ; error 50892 "-1 is outside the range 0 … 4294967295 of V.E.COUNT"
    V.E.COUNT -= 5
    V.E.FLAG = 7 ; warning 901051 "V.E.FLAG is of type BOOLEAN: 7 counts as 1"
    V.E.FLAG = 0.2 ; warning 901051 "0.2 counts as 0"
    V.E.FLAG = 1
  $ENDIF
#RT CYCLE END
V.E.COUNT = 99999999999 ; error 20847 "99999999999"
V.E.FLAG = -1 ; warning 901051 "-1 counts as 1"
; --- positions that an axis never reaches
#RT CYCLE [ID=1 SCOPE=PROG]
  $IF ONCE V.RTA.ACS.ACT_POS.X > 10000.1 ; warning 901052 "between -10000 and 10000: this comparison is never true"
    M100
  $ENDIF
  $IF ONCE -10001 < V.RTA.ACS.CMD_POS.X ; warning 901052 "V.RTA.ACS.CMD_POS.X is between -10000 and 10000: this comparison is always true"
    M100
  $ENDIF
  $IF ONCE V.RTA.ACS.ACT_POS.A > 400 ; warning 901052 "between 0 and 360: this comparison is never true"
    M100
  $ENDIF
  $IF ONCE V.RTA.ACS.ACT_POS.A <= 360 && V.RTA.ACS.ACT_POS.X >= 10000
    M100
  $ENDIF
  $IF ONCE V.RTA.WCS.ACT_POS.X > 20000
    M100
  $ENDIF
  $IF ONCE V.E.VALUE > 1
    X[INDP G90 POS=20000] ; error 60158 "the target 20000 of axis X"
    X[INDP G90 POS=20000 OFFSET=ZERO]
    X[INDP G91 POS=20000]
    A[INDP G90 POS=720]
  $ENDIF
#RT CYCLE END
; --- in inches 10000 mm are 393.7 (manual 4.5.3)
G70
#RT CYCLE [ID=1 SCOPE=PROG]
  $IF ONCE V.RTA.ACS.ACT_POS.X > 400 ; warning 901052 "never true"; note 901001 "in inches"
    M100
  $ENDIF
#RT CYCLE END
; --- the same ID twice (RC-108)
#RT CYCLE [ID=5 SCOPE=PROG]
#RT CYCLE END
#RT CYCLE [ID=5 SCOPE=PROG] ; error 50900 "the ID 5"
#RT CYCLE END
P1 = 5
#RT CYCLE [ID=P1 SCOPE=GLOBAL] ; error 50900 "the ID 5"
#RT CYCLE END
#RT CYCLE DELETE [ID=5]
#RT CYCLE [ID=5 SCOPE=PROG]
#RT CYCLE END
; --- the same ID in branches of which one runs, and behind a call that may delete
$IF P2 == 1
#RT CYCLE [ID=6 SCOPE=PROG]
#RT CYCLE END
$ELSE
#RT CYCLE [ID=6 SCOPE=PROG]
#RT CYCLE END
$ENDIF
#RT CYCLE [ID=6 SCOPE=PROG] ; error 50900 "the ID 6"
#RT CYCLE END
$IF P2 == 1
#RT CYCLE DELETE [ID=6]
$ENDIF
#RT CYCLE [ID=6 SCOPE=PROG]
#RT CYCLE END
; --- a BLOCK cycle frees its ID
#RT CYCLE [ID=7 SCOPE=BLOCK]
#RT CYCLE END
G00 X1
#RT CYCLE [ID=7 SCOPE=PROG]
#RT CYCLE END
M30
