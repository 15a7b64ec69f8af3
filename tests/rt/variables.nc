; Synchronous variables and their indices are read in each tick; asynchronous ones are frozen, unless
; Vs. asks for the value of the tick (RC-302, RC-307).
; --set V.E.ASYNC=2.5
#RT CYCLE [ID=1]
  V.E.LIST[1] = V.E.LIST[V.E.COUNT]
  V.E.LIST[V.E.COUNT + 1] += V.E.ASYNC
  $IF Vs.E.ASYNC > V.E.LIST[0]
    #TIMER START SYN [ID=V.E.COUNT]
    M100 M101
  $ENDIF
#RT CYCLE END
M30
