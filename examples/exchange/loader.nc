%loader
; The other channel: it turns the table under its gripper. Runs with mill.nc.
N10 #CALL AX [C, 3, 1]       ; waits for the table: name C, logical number 3, index 1
N20 G01 X30 C180 F6000       ; loader and table in one path
N30 #PUT AX [C]              ; the mill may have it again
N40 G01 X0
N50 M30
