; Der Zyklus des Programms davor läuft noch.
#TIME 0.002
#RT CYCLE DELETE [ID = 17]
M30
