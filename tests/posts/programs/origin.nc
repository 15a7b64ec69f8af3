; origin of the well: G805 [x, y, z]
G92 X@P1 Y@P2 Z@P3
M17
