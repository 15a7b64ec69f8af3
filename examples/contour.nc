%contour
; A part from outside, clockwise, the tool to the left of its way; tool 1 has a radius of 5 mm.
N10 G00 X-25 Y-25
N20 D1 G25 ; around outer corners in lines; G26: in arcs
N30 G01 G41 X0 Y0 F6000 ; to the contour
N40 Y40
N50 G02 X20 Y60 I20 J0
N60 G01 X50
N70 Y40
N80 X80
N90 X110 Y65
N100 X100 Y20
N110 G03 X80 Y0 I0 J-20
N120 G01 X-10
N130 G40 X-25 Y-25 ; from the contour
M30
