%five_axes
; Around a plate with a leaning tool, on the machine demo5: nctakt run examples/five_axes.nc --machine demo5
N10 T1 D1
N20 G00 X0 Y0 Z200 C0 A0
; from here on X Y Z are those of the tool's tip, and the linear axes follow the rotary ones
N30 #TRAFO ON
N40 G00 X10 Y10 Z20
N50 G01 Z0 F2000
N60 X110 A30 F4000
N70 Y70 C90
N80 X10 A20
N90 Y10 C0 A0
N100 G00 Z100
N110 #TRAFO OFF
M30
