; Ohne ID könnte später niemand den globalen Zyklus ansprechen.
#RT CYCLE [ID = 17 SCOPE = GLOBAL]
  V.E.COUNT += 1
#RT CYCLE END
#TIME 0.003
M30
