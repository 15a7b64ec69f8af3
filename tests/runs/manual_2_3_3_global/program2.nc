; The cycle of the program before this one is still running.
#TIME 0.002
#RT CYCLE DELETE [ID = 17]
M30
