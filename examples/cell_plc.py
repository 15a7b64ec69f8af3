# SPDX-License-Identifier: MIT
"""A cell's PLC: ``nctakt run examples/crossing.nc --plc examples/cell_plc.py``."""

from nctakt import Function, HliView, Plc, after, at, on, when


class Cell(Plc):
    """Acknowledges after 20 ticks; values at times from cell_inputs.csv."""

    acknowledge = after("20 ticks")
    inputs = "cell_inputs.csv"

    @at("0.5s")
    def slow_down(self, hli: HliView) -> None:
        hli.override_pct = 50

    @when("V.RTA.ACS.ACT_POS.X > 400")
    def near_the_end(self, hli: HliView) -> None:
        hli.override_pct = 20

    @on("M100")
    def clamp(self, hli: HliView, function: Function) -> None:
        hli.write("V.E.CONDITION", 1)
