# SPDX-License-Identifier: MIT
"""A workpiece whose edge is at X42.3: the probe touches while X is behind it, less its ball."""

from nctakt import HliView, Plc

EDGE_MM = 42.3
BALL_MM = 2.0


class Workpiece(Plc):
    """Sets the signal of the probe, and acknowledges functions at once."""

    def cycle(self, hli: HliView) -> None:
        hli.acknowledge_all()
        hli.write("HLI.PROBE", float(hli.read("V.RTA.ACS.CUR_POS.X")) >= EDGE_MM - BALL_MM)
