#RT CYCLE [ID = 1 SCOPE = BLOCK]
  V.E.COUNT += 1
#RT CYCLE END
; the queue is held up before there is a block to run in
#FLUSH WAIT
#TIME 0.002
#TIME 0.002
M30
