%c_axis
; A square on the face of a turned part and a groove around it, on the machine demo5:
; nctakt run examples/c_axis.nc --machine demo5
N10 G00 X60 Y0 Z5 C0
; from here on X and C are places on the face, in mm: C turns, and X goes in and out
N20 #FACE [X, C]
N30 G01 X30 C-20 F3000
N40 Z-2 F500
N50 C20 F2000
N60 G03 X20 C30 I-10 J0
N70 G01 X-30
N80 C-20
N90 G03 X-20 C-30 I10 J0
N100 G01 X20
N110 G03 X30 C-20 I0 J10
N120 G00 Z5
N130 #FACE OFF
N140 G00 X62 C0
; from here on C is the way around the cylinder of the radius 60, in mm
N150 #CYL [Z, C, X60]
N160 G00 Z-20
N170 G01 X58 F500
N180 Z-50 C40 F2000
N190 G02 Z-50 C80 I0 J20
N200 G01 Z-20 C120
N210 G00 X62
N220 #CYL OFF
N230 G00 X100 Z100 C0
M30
