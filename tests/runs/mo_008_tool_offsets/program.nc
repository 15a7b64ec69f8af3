N10 D1 G00 Z-50 ; length 100
N20 G18
N30 Y-80
N40 D3 G17 X40 ; length 120, 1 mm beside the spindle in X
N50 V.G.WZ_AKT.L = 30
N60 G91 Z5 ; relative: the new offset moves nothing
N70 G90 D0 X41 Z0
M30
