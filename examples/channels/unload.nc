%unload
; The other channel: its axis X moves the gripper. Runs with load.nc.
N10 #WAIT SYN [ID=1 CH=1]    ; the part is there, at 0.6 s
N20 G01 X-30 F6000           ; 30 mm, 0.4 s
N30 #SIGNAL SYN [ID=2 CH=1]  ; channel 1 comes first in a tick: it goes on in the next one
N40 G01 X0
N50 M30
