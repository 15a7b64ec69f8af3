/ #MSG ["level 1"]
/2 #MSG ["level 2"]
/3 $IF 1
  #MSG ["in the branch"]
/3 $ENDIF
/10 #MSG ["level 10"]
#MSG ["always"]
M30
