; no blank before the bracket, SCOPE before ID
N10 #RT CYCLE[SCOPE=PROG ID=3]
N20 V.E.COUNT_POS=1
N30 #RT CYCLE END
; many blanks, all keywords
#RT CYCLE DEF[END_ACTION = MOVE_CONT   SCOPE  =  GLOBAL ID =   4]
#RT CYCLE END
#RT CYCLE
#RT CYCLE END
#RT CYCLE [ID=5]
  $IF V.E.VALUE == 0
  $ENDIF
  N5
  ; first neither, then the last
  $IF V.E.VALUE > 0
  $ELSEIF V.E.VALUE < 0
  $ELSE
  $ENDIF
  $IF ONCE V.E.VALUE == 0
  $ENDIF
#RT CYCLE END ; with a comment
#RT CYCLE [END_ACTION=MOVE_ABORT]
  ( only this )
#RT CYCLE END
N40 #RT CYCLE START[ID=4]
M30
