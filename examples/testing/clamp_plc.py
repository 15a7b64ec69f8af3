"""The clamp of the cell: it takes 50 ms, and says so in V.E.CONDITION."""

from nctakt import Function, HliView, Plc, after, on


class Clamp(Plc):
    """Acknowledges each function 50 ms later."""

    acknowledge = after("50 ms")

    @on("M111")
    def close(self, hli: HliView, function: Function) -> None:
        hli.write("V.E.CONDITION", 1)
