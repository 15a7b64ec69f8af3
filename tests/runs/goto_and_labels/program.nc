%GOTO
; jumps backward, forward, and into a branch whose condition is false
P1 = 0
N10: P1 += 1
#MSG ["pass %d", P1]
#TIME 0.002
$IF P1 < 2 $GOTO N10
$GOTO [inside]
#MSG ["never"]
$IF P1 == 1
  #MSG ["never"]
$ELSEIF P1 == 7
  #MSG ["never"]
  [INSIDE]
  #MSG ["entered"]
  #TIME 0.001
$ELSE
  #MSG ["never"]
$ENDIF
$FOR P2 = 3, 1, -1
  $IF P2 == 2 $GOTO N80
  #MSG ["round %d", P2]
$ENDFOR
#MSG ["never"]
N80: P3 = 0
$SWITCH 2
$CASE 1
  #MSG ["never"]
  N90: #MSG ["case 1"]
$CASE 2
  #MSG ["case 2"]
  P3 += 1
  $IF P3 == 1 $GOTO N90
  $BREAK
$DEFAULT
  #MSG ["never"]
$ENDSWITCH
$GOTO [LAST]
M30
#MSG ["never"]
[LAST]
#MSG ["behind M30"]
M30
