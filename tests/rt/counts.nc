; Each kind of node counts once, constants are free (RC-501).
#RT CYCLE [ID=1]
  V.E.VALUE1 = 7
  V.E.COUNT = V.E.COUNT + 1
  V.E.COUNT += 1
  V.E.VALUE1 = -V.E.VALUE2 ** 2 + SIN[30] * ATAN2[V.E.VALUE1, 2]
  V.E.VALUE2 = PI / [3 - 1]
  V.E.VALUE1
  M100
#RT CYCLE END
M30
