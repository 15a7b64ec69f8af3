%L ONE
P1 += 1
#MSG ["one: %d", P1]
#TIME 0.001
M17
#MSG ["never"]
%L TWO
#MSG ["two"]
LL ONE
$IF P1 > 3
  M29
$ENDIF
#MSG ["no end but the next one"]
%L DEEP
LL DEEPER
#MSG ["not reached"]
M17
%L DEEPER
M17 [JUMPS=2 [AFTER]]
%L HOME
LL HOME2
M17
%L HOME2
M17 [MAIN] N90
%MAIN
P1 = 0
LL ONE
G00 LL TWO
P1 = 3
LL TWO
LL DEEP
#MSG ["not reached"]
[AFTER]
LL HOME
#MSG ["not reached"]
N90: #MSG ["home"]
M30
