%load
; Two channels hand over a part. Each has an axis X of its own: here that of the loader.
; given: channel 2 unload.nc
N10 G01 X50 F6000            ; the part comes: 50 mm at 100 mm/s and 1000 mm/s², 0.6 s
N20 #SIGNAL SYN [ID=1 CH=2]  ; expect: CH1.X = 50 at 600ms
N30 #WAIT SYN [ID=2 CH=2]    ; until the gripper has it
N40 G01 X0                   ; expect: CH1.X = 50 at 1001ms; expect: CH1.X = 0 at end
N50 #MSG ["ready"]           ; expect: message "ready" at 1601ms
N60 M30                      ; expect: ended
