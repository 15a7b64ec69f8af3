# SPDX-License-Identifier: MIT
"""Variables at fixed addresses that share bits on a controller (ST-402).

Addresses count bytes, regardless of their letter: ``%IW2`` are the bytes 2 and 3, ``%IX2.7`` is the
last bit of byte 2.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from operator import itemgetter

from nctakt.messages.plcs.st_check import ADDRESSES_OVERLAP
from nctakt.st.program import Program
from nctakt.st.reporting import Reporter
from nctakt.st.types import Kind, Variable

_ADDRESS = re.compile(r"%([IQM])(X?)[BWDL]?(\d+)(?:\.(\d+))?", re.ASCII)


def report_overlaps(program: Program, reporter: Reporter) -> None:
    """Report variables that share bits on a controller, and have separate memory here."""
    owners = [group.variables for group in program.lists]
    owners += [pou.members for pou in program.pous.values() if pou.kind is Kind.PROGRAM]
    found = [one for variables in owners for one in variables.values() if one.address]
    for variable, other in _overlapping(found):
        end = variable.start + len(variable.name)
        reporter.report(
            ADDRESSES_OVERLAP, variable.start, end, name=variable.name, other=other.name
        )


def _overlapping(variables: Iterable[Variable]) -> Iterator[tuple[Variable, Variable]]:
    """Yield each variable that shares bits with one that begins before it, and that one."""
    areas: dict[str, list[tuple[int, int, int, Variable]]] = {}
    for variable in variables:
        parts = _ADDRESS.fullmatch(variable.address)
        if parts is not None:
            area, is_bit, byte, bit = parts.groups()
            begin = 8 * int(byte) + int(bit or 0)
            size = 1 if is_bit or bit else 8 * variable.type.size
            areas.setdefault(area, []).append((begin, begin + size, variable.start, variable))
    for entries in areas.values():
        reach, last = 0, None
        for begin, end, _, variable in sorted(entries, key=itemgetter(0, 1, 2)):
            if last is not None and begin < reach:
                yield variable, last
            if end > reach:
                reach, last = end, variable
