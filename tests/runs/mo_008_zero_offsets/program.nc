N10 G54
N20 G00 X10
N30 G55 G91 X15 ; relative: the new offset moves nothing
N40 G90 X100
N50 G92 X20 Y5
N60 X100 Y0
N70 G91 G92 X1 ; in addition to the 20
N80 G90 G53 X0
M30
