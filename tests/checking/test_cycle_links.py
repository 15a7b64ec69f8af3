# SPDX-License-Identifier: MIT
"""Cycles that nothing starts, and starts of cycles that nothing defines (RC-102, RC-111)."""

from __future__ import annotations

from pathlib import Path

import pytest

from nctakt.checking.check import check_files
from nctakt.lists.machine.machine import load_machine
from nctakt.run.realtime.assembly import AssembledMachine

DEF = "#RT CYCLE DEF [ID=7 SCOPE=PROG]\n  V.E.COUNT = 1\n#RT CYCLE END\n"
START = "#RT CYCLE START [ID=7]\n"
NEVER_STARTED, NOT_DEFINED = 901986, 901987


@pytest.fixture(scope="module")
def machine() -> AssembledMachine:
    return AssembledMachine(load_machine(None))


def warnings(
    machine: AssembledMachine, folder: Path, *named: str, **texts: str
) -> list[tuple[str, int, int]]:
    """File, line and number of the warnings; ``named``: the files that are checked."""
    for name, text in texts.items():
        (folder / f"{name}.nc").write_text(text, "utf-8")
    paths = [folder / f"{name}.nc" for name in named or texts]
    found = [one.diagnostic for one in check_files(paths, machine).findings]
    return [
        (Path(one.span.file).stem, one.span.line, one.id)
        for one in found
        if one.id in (NEVER_STARTED, NOT_DEFINED) and one.span
    ]


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        (f"{DEF}M30\n", [(1, NEVER_STARTED)]),
        (f"{DEF}#RT CYCLE START [ID=8]\nM30\n", [(1, NEVER_STARTED), (4, NOT_DEFINED)]),
        (f"{START}M30\n", [(1, NOT_DEFINED)]),
        (f"{DEF}$IF P1 > 3\n{START}$ENDIF\nM30\n", []),
        (f"P1 = 7\n{DEF}#RT CYCLE START [ID=P1]\nM30\n", []),
        (f"{DEF}#RT CYCLE START [ID=V.E.COUNT]\nM30\n", []),
        (f"{DEF.replace('PROG', 'GLOBAL')}M30\n", []),
        (f"{DEF.replace('ID=7', 'ID=V.E.COUNT')}{START}M30\n", []),
        (f"{DEF.replace('DEF ', '')}M30\n", []),
        (f"%L SUB\n{START}M17\n%MAIN\n{DEF}LL SUB\nM30\n", []),
        (f"{DEF}L V.P.NAME\nM30\n", []),
        (f'"GO" = "M5"\n{DEF}"GO"\nM30\n', []),
        (f"{DEF}L missing.nc\nM30\n", []),
        (f"{DEF}M17\n", []),
        (f"{START}M17\n", []),
        (DEF, []),
    ],
)
def test_one_program(
    text: str, expected: list[tuple[int, int]], machine: AssembledMachine, tmp_path: Path
) -> None:
    """Computed IDs and calls, and callers that are not known, may mean any cycle."""
    found = warnings(machine, tmp_path, part=text)
    assert [(line, number) for _, line, number in found] == expected


def test_programs_that_call_each_other(machine: AssembledMachine, tmp_path: Path) -> None:
    """Files that a checked program calls are checked with it, whether they are named or not."""
    main, sub = f"{DEF}L sub.nc\nM30\n", f"{START}M17\n"
    assert warnings(machine, tmp_path, "main", main=main, sub=sub) == []
    assert warnings(machine, tmp_path, "sub", main=main, sub=sub) == []
    quiet = "G00 X1\nM17\n"
    assert warnings(machine, tmp_path, "main", main=main, sub=quiet) == [("main", 1, NEVER_STARTED)]
    left = DEF.replace("PROG", "GLOBAL") + "M30\n"
    assert warnings(machine, tmp_path, before=left, after=f"{START}M30\n") == []
    other = f"{START}L sub.nc\nM30\n"
    found = warnings(machine, tmp_path, main=main, other=other, sub=f"{START}M17\n")
    assert found == [("other", 1, NOT_DEFINED)]
