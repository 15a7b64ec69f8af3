P1 = V.CH.Total
P2 = V.CH.Var_name
#MSG ["%f %d", P1, P2]
M30
