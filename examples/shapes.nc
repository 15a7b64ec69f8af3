%shapes
; Chamfers, roundings and a spline between lines. Look at it:
;   nctakt run examples/shapes.nc --plot shapes.html
N10 G00 X0 Y0
N20 G01 X60 F3000
N30 G301 I10               ; chamfer, 10 mm on both sides of the corner
N40 G01 Y30 #RND=8         ; rounding with the radius 8 at the end of this block
N50 G01 X40
N60 #AKIMA TRANS [START=TANGENTIAL END=TANGENTIAL]
N70 G151                   ; Akima spline from here on
N80 G01 X30 Y38
N90 X20 Y28
N100 X10 Y36
N110 X0 Y30
N120 G150
N130 G01 X-10
N140 G302 I6
N150 G01 Y0
N160 M30
