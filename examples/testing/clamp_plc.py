"""The clamp of the cell: it takes 50 ms, and says so in V.E.CONDITION."""

from nctakt.plc import Plc, after, on


class Clamp(Plc):
    """Acknowledges each function 50 ticks later."""

    acknowledge = after(50)

    @on("M111")
    def close(self, hli, function):
        hli.write("V.E.CONDITION", 1)
