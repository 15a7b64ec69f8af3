; Every keyword of a single-axis command, in any order (RC-405, RC-407)
#RT CYCLE [ID=1]
  X[INDP ABORTING OFFSET=ALL G90 G01 FEED=500 POS=100]
  X[POS=100 FEED=500 G01 G90 OFFSET=ZERO BUFFERED INDP]
  X [ INDP , G91 , POS = V.E.VALUE ]
  Z[INDP G90 G0 POS=-10]
  Z[INDP G91 POS-10 FEED500]
  Z[INDP DIR=POS FEED=1000]
  Z[INDP DIR=CUR FEED=1000]
  Z[INDP DIR=NEG FEED=1000]
  Z[INDP DIR=V.E.VALUE-1 FEED=SQRT[V.E.COUNT]]
  Z[INDP G01 FEED=-1000]
  Z[INDP G90 FEED=1000]
  Z[INDP STOP]
  A[INDP G90 G00 POS=90 DIR=NEG]
  A[INDP G90 G00 POS=90 DIR=V.E.VALUE]
  N10 Z[INDP OFFSET=ADD_ZERO G90 G00 POS=1] M100
  Z[INDP OFFSET=PSET G90 POS=1] X[INDP STOP]
  Z[INDP OFFSET=CLAMP G90 POS=1]
  Z[INDP OFFSET=TOOL G90 POS=1]
  Z[INDP OFFSET=MEASURE G90 POS=1]
  Z[INDP OFFSET=MANUAL G90 POS=1]
  $IF V.E.TRIGGER
    Z[INDP G90 G01 POS=1]
  $ENDIF
#RT CYCLE END
; --- each keyword once (22032)
#RT CYCLE
  X[INDP INDP STOP] ; error 22032 "INDP"
  X[ABORTING G90 POS=1] ; error 901984 "ABORTING"
  X[G90 STOP] ; error 901984 "STOP"
  X[INDPP POS=1] ; error 901985 "INDPP"
  X[OSK ON] ; error 901985 "OSK"
  X[INDP STOP STOP] ; error 22032 "STOP"
  X[INDP ABORTING ABORTING FEED=1] ; error 22032 "ABORTING"
  X[INDP G90 G90 POS=1] ; error 22032 "G90"
  X[INDP G1 G01 FEED=1] ; error 22032 "G01"
  X[INDP FEED=1 FEED=2] ; error 22032 "FEED"
  X[INDP G90 POS=1 POS=1] ; error 22032 "POS"
  X[INDP DIR=POS DIR=NEG FEED=1] ; error 22032 "DIR"
  X[INDP OFFSET=ALL OFFSET=ZERO G90 POS=1] ; error 22032 "OFFSET"
  X[INDP G90 POS=1 POS=2 G90] ; error 22032 "POS" ; error 22032 "G90"
#RT CYCLE END
; --- other G functions (50965)
#RT CYCLE
  X[INDP G02 FEED=1] ; error 50965 "G2 is not allowed in X[INDP …]"
  X[INDP G90 G04 POS=1] ; error 50965 "G4"
  X[INDP G90.5 POS=1] ; error 50965 "G90.5"
  X[INDP G=V.E.VALUE POS=1] ; error 50965 "G is not allowed in X[INDP …]"
  X[INDP G90 G53 POS=1 G805] ; error 50965 "G53" ; error 50965 "G805"
#RT CYCLE END
; --- combinations (50967)
#RT CYCLE
  X[INDP STOP G90] ; error 50967 "STOP must be alone"
  X[INDP STOP FEED=10] ; error 50967 "STOP must be alone"
  X[INDP ABORTING STOP] ; error 50967 "STOP must be alone"
  X[INDP STOP POS=1] ; error 50967 "STOP must be alone"
  X[INDP STOP OFFSET=ALL] ; error 50967 "STOP must be alone"
  X[INDP STOP DIR=POS] ; error 50967 "STOP must be alone"
  X[INDP ABORTING BUFFERED FEED=1] ; error 50967 "ABORTING or BUFFERED"
  X[INDP G90 G91 POS=1] ; error 50967 "G90 or G91"
  X[INDP G90 G00 G01 POS=1] ; error 50967 "G00 or G01"
  X[INDP POS=1] ; error 50967 "POS needs G90 or G91"
  X[INDP G00 POS=1] ; error 50967 "POS needs G90 or G91"
  X[INDP G00 FEED=1]
  X[INDP G90 G00 POS=1 FEED=1]
  X[INDP FEED=0] ; error 50967 "FEED must not be 0"
  X[INDP G90 POS=1 FEED=0] ; error 50967 "FEED must not be 0"
  X[INDP G90 POS=1 FEED=-1] ; error 50967 "above 0"
  X[INDP G90 POS=1 DIR=POS]
  A[INDP G91 G00 POS=1 DIR=POS] ; error 50967 "with G91"
  X[INDP FEED=1 DIR=1]
  X[INDP FEED=1 DIR=0]
  X[INDP FEED=1 DIR=-1]
  X[INDP FEED=1 DIR=2] ; error 50967 "DIR must be POS (1), CUR (0) or NEG (-1)"
  X[INDP FEED=1 DIR=-0.5] ; error 50967 "DIR must be"
  A[INDP G90 G00 POS=1 DIR=3] ; error 50967 "DIR must be"
  X[INDP] ; error 50967 "POS, FEED or STOP is missing"
  X[INDP DIR=POS] ; error 50967 "POS, FEED or STOP is missing"
  X[INDP G00] ; error 50967 "POS, FEED or STOP is missing"
  X[INDP POS=1 G00 FEED=0] ; error 50967 "0" ; error 50967 "needs G90"
#RT CYCLE END
; --- POS with G01 and no FEED for that axis in the whole cycle (50967)
#RT CYCLE
  X[INDP G90 G01 POS=1] ; error 50967 "needs FEED"
  Z[INDP FEED=100]
  Z[INDP G90 G01 POS=1]
#RT CYCLE END
#RT CYCLE
  Z[INDP G90 G01 POS=1] ; error 50967 "needs FEED"
#RT CYCLE END
; --- axes (RC-406): Y may not be moved on its own here
#RT CYCLE
  Y[INDP STOP] ; error 50966 "Y must not be moved independently (P-AXIS-00457)"
  Y[INDP POS=1] ; error 50966 "Y" ; error 50967 "POS needs G90 or G91"
  Q[INDP STOP] ; error 20797 "Q[INDP STOP]"
  B1[INDP STOP] ; error 20797 "B1[INDP STOP]"
  S[INDP STOP] ; error 900262 "S is a spindle"
  S2[INDP FEED=100] ; error 900262 "S2 is a spindle"
#RT CYCLE END
; --- keywords that are none, values that are missing or too many
#RT CYCLE
  X[INDP FEAD=100] ; error 21068 "X[INDP …]: unknown keyword FEAD"
  X[INDP G90 POS 10] ; error 900208 "POS" ; error 21068 "X[INDP …]: unknown keyword 10"
  X[INDP G90 POS[10]] ; error 21068 "POS"
  X[INDP FEED] ; error 900208 "FEED"
  X[INDP ABORTING=1 FEED=1] ; error 21068 "ABORTING takes no value"
  X[INDP STOP=1] ; error 21068 "STOP takes no value"
  X[INDP DIR=LEFT FEED=1] ; error 900225 "DIR = LEFT"
  X[INDP DIR=POS+0 FEED=1] ; error 900225 "DIR = POS+0 is"
  X[INDP DIR=-CUR FEED=1] ; error 900225 "DIR = -CUR is"
  X[INDP OFFSET=NONE G90 POS=1] ; error 900225 "OFFSET = NONE"
  X[INDP OFFSET=1 G90 POS=1] ; error 900225 "OFFSET = 1"
  X[INDP OFFSET G90 POS=1] ; error 900208 "OFFSET"
  X[OVERRIDE FEED_FACT=50] ; error 900200 "X[…]"
#RT CYCLE END
; --- expressions are those of the cycle
#RT CYCLE
  X[INDP G90 POS=V.E.NONE] ; error 20196 "V.E.NONE"
  X[INDP FEED=FAST] ; error 20392 "FAST"
  X[INDP FEED="100"] ; error 21981 ""
#RT CYCLE END
; --- outside of realtime cycles
X[INDP G90 POS=1] ; error 900260 "X[INDP …] belongs in a realtime cycle"
