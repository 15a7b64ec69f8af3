; Z runs on and on in positive direction as soon as X is beyond 1
N10 #RT CYCLE [SCOPE = PROG]
N20 $IF ONCE V.RTA.ACS.ACT_POS.X > 1
N30   Z [INDP DIR = POS FEED = 1000]
N40 $ENDIF
N50 #RT CYCLE END

N60 G01 X100

N70 M30
