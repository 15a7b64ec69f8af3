N10 D1 G360 G238 G41 G01 X-15 Y-5 F30000 ; radius 5, to the inner corner
N20 X35
N30 Y45
N40 X-15
N50 Y-5
N60 G40 X0 Y0 ; from the contour
M30
