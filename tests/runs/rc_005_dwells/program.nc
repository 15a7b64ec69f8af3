G04 X0.0025
#MSG ["a"]
G04 0.001
#MSG ["b"]
#TIME 0
#MSG ["c"]
P1 = 0.0042
G04 P1
#MSG ["d"]
G04 X0.003
#MSG ["e"]
M30
