; Two cycles for the same block.
#RT CYCLE [ID = 1 SCOPE = BLOCK]
  V.E.COUNT_POS += 1
#RT CYCLE END
#RT CYCLE [ID = 2 SCOPE = BLOCK]
  V.E.COUNT_NEG += 1
#RT CYCLE END
; blocks that take no tick are not the next block
G00 X0
V.E.VALUE = 7
; this one is
#TIME 0.003
#TIME 0.003
M30
