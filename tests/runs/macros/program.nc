"DOWN" = "P1 += 1"
"WAIT" = "G04 0.002"
"WHERE" = "X[P1 * 2]"
"DOWN"
N20 "WAIT"
N30 G00 "WHERE" T1
"DOWN" = "P1 += 3"
"DOWN"
#MSG ["%g", P1]
"CALL" = "LL SUB"
"CALL"
M30
%L SUB
#MSG ["sub"]
M17
