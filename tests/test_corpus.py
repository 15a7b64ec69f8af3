# SPDX-License-Identifier: MIT
"""Programs that nobody here wrote: what becomes of each, where NCTAKT_CORPUS names their folder.

The table shows for each file whether it runs to its end, or a line and the number that refuses it:
G20 and G21 are mirroring in this dialect, not units; ``[…]`` is a label, not a comment; files for
tests of editors hold lines that are no NC text. The files are not part of the project.
"""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from nctakt.run.controller import Controller

CORPUS = Path(os.environ.get("NCTAKT_CORPUS", ""))

#: Ticks that a program may take: the longest one has hours.
TICKS = 100_000_000

#: Ticks of each file, whatever becomes of it.
FEW_TICKS = 200

RUNS = (0, 0)

#: Refused when they get there: what comes before has run.
ON_THE_WAY = ("cncjs/examples_gcode_full-circle-without-xyz.gcode",)

#: File -> line and number of a diagnostic, or that it runs.
OUTCOMES: dict[str, tuple[int, int]] = {
    "cncjs/examples_gcode_Circle_Diamond_Square_Calibration.gcode": (2, 900200),
    "cncjs/examples_gcode_arc-ijk.gcode": RUNS,
    "cncjs/examples_gcode_arc-xy-plane.gcode": RUNS,
    "cncjs/examples_gcode_arc-xz-plane.gcode": RUNS,
    "cncjs/examples_gcode_arc-yz-plane.gcode": RUNS,
    "cncjs/examples_gcode_circle-inch.gcode": (1, 900200),
    "cncjs/examples_gcode_circle.gcode": (1, 900200),
    "cncjs/examples_gcode_full-circle-without-xyz.gcode": (11, 20036),
    "cncjs/examples_gcode_g2-arc.gcode": (1, 900200),
    "cncjs/examples_gcode_helical-thread-milling.gcode": (2, 900200),
    "cncjs/examples_gcode_jsdc.gcode": (1, 900200),
    "cncjs/examples_gcode_octocat.gcode": (2, 20052),
    "cncjs/examples_gcode_part.gcode": (2, 20052),
    "cncjs/examples_gcode_tball_tball-engrave.gcode": (1, 900200),
    "cncjs/examples_gcode_tball_tball-pocket.gcode": (1, 900200),
    "gpr/gcode_samples_camaster_sample.tap": (1, 20797),
    "gpr/gcode_samples_linuxcnc_sample.ngc": RUNS,
    "isg-vscode/Folding_examples.nc": (7, 20392),
    "isg-vscode/alignComments_test.nc": (11, 20566),
    "isg-vscode/alignComments_test_expected.nc": (11, 20566),
    "isg-vscode/alignEqualSign_test.nc": (14, 900116),
    "isg-vscode/alignEqualSign_test_expected.nc": (14, 900116),
    "isg-vscode/blockNumberBug1.nc": (5, 20797),
    "isg-vscode/blockNumbers_test_added_excludingComments_default.nc": (2, 20797),
    "isg-vscode/blockNumbers_test_added_excludingComments_replaced.nc": (2, 20797),
    "isg-vscode/blockNumbers_test_added_includingComments_default.nc": (2, 20797),
    "isg-vscode/blockNumbers_test_added_includingComments_replaced.nc": (2, 20797),
    "isg-vscode/blockNumbers_test_removed.nc": (2, 20797),
    "isg-vscode/docHover1.nc": (22, 20797),
    "isg-vscode/docHover2.nc": (22, 20797),
    "isg-vscode/fileContentTree_test.nc": (7, 20373),
    "isg-vscode/formatter_test_formatted.nc": (39, 900113),
    "isg-vscode/formatter_test_unformatted.nc": (39, 900113),
    "isg-vscode/ignoreCommentedText_test.nc": (1, 20797),
    "isg-vscode/isgCycles_test.nc": (2, 20397),
    "isg-vscode/multiRoot1/calledProgram.nc": (2, 900200),
    "isg-vscode/multiRoot1/callingProgram1.nc": (2, 900200),
    "isg-vscode/multiRoot2/calledProgram.nc": (5, 20797),
    "isg-vscode/multiRoot2/callingProgram2.nc": (5, 20797),
    "isg-vscode/non_Ascii_Characters_test.nc": RUNS,
    "isg-vscode/parsingResults_test.nc": (5, 20797),
    "isg-vscode/subPrograms.nc": (3, 20797),
    "isg-vscode/test.nc": (4, 22002),
    "isg-vscode/testWithEverything.nc": (5, 20797),
    "isg-vscode/variables_test.nc": (1, 20797),
}

_FILES = sorted(CORPUS.rglob("*.*")) if "NCTAKT_CORPUS" in os.environ else []


def _name(path: Path) -> str:
    return path.relative_to(CORPUS).as_posix()


@pytest.mark.skipif(not _FILES, reason="NCTAKT_CORPUS names no folder")
@pytest.mark.parametrize("name", OUTCOMES)
def test_each_foreign_program_runs_or_is_refused_for_its_reason(name: str) -> None:
    """The diagnostic of the table is among those of the run, and nothing has moved."""
    run = Controller().run(CORPUS / name, memory_trace=False, ticks=TICKS)
    if OUTCOMES[name] == RUNS:
        assert (run.state, run.errors) == ("ended", ())
        return
    places = [(error.span.line, error.id) for error in run.errors if error.span is not None]
    assert OUTCOMES[name] in places
    assert (run.ticks > 0) == (name in ON_THE_WAY)


@pytest.mark.skipif(not _FILES, reason="NCTAKT_CORPUS names no folder")
def test_each_foreign_program_is_in_the_table() -> None:
    """All but the notes about where they come from."""
    programs = [_name(path) for path in _FILES if path.suffix != ".md"]
    assert programs == sorted(OUTCOMES)


@pytest.mark.parametrize("path", _FILES, ids=_name)
def test_no_foreign_program_is_a_fault_of_nctakt(path: Path) -> None:
    """Each file, whatever it is, runs or has diagnostics that can be shown."""
    run = Controller().run(path, memory_trace=False, ticks=FEW_TICKS)
    assert run.state in ("ended", "limit") or run.errors
    for error in run.errors[:50]:
        assert error.render("de")
