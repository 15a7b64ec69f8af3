#MSG ["before"]
N10 G00 X1
#MSG ["between"]
#RT CYCLE [ID = 1 SCOPE = PROG]
#RT CYCLE END
#MSG ["number %d, value %f", 3, 1.5]
#TIME 0.002
#MSG ["after"]
M30
