#MSG ["main"]
M6
G805[7, "text"] G00 X1
G81 [3]
M30
