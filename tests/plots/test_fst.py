# SPDX-License-Identifier: MIT
"""FST files of runs: the same changes as in VCD, read back by the format's own code."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

from nctakt.cli import main
from nctakt.files.fst import write_fst_file
from nctakt.files.vcd import VcdVariable
from nctakt.run.controller import Controller

pylibfst = pytest.importorskip("pylibfst", reason="FST needs pylibfst (extra measure)")


def changes_of(path: Path) -> dict[str, list[tuple[int, str]]]:
    """Return the changes of each variable of a file: time and value as a text."""
    lib = pylibfst.lib
    reader = lib.fstReaderOpen(str(path).encode())
    _, signals = pylibfst.helpers.get_scopes_signals2(reader)
    names: dict[int, str] = {one.handle: name for name, one in signals.by_name.items()}
    found: dict[str, list[tuple[int, str]]] = {name: [] for name in signals.by_name}

    def note(_: Any, time: int, handle: int, value: Any) -> None:
        found[names[handle]].append((time, pylibfst.helpers.string(value)))

    def note_text(_: Any, time: int, handle: int, value: Any, size: int) -> None:
        found[names[handle]].append((time, pylibfst.ffi.buffer(value, size)[:].decode()))

    lib.fstReaderSetFacProcessMaskAll(reader)
    pylibfst.helpers.fstReaderIterBlocks2(reader, note, note_text, None)
    lib.fstReaderClose(reader)
    return found


def test_all_kinds_come_back(tmp_path: Path) -> None:
    """First values at the begin, then the changes in the order of time, names made unique."""
    variables = [
        VcdVariable(("a", "b"), "wire", "wire", [(3, 1), (5, 0)]),
        VcdVariable(("a",), "truth", "truth", [(4, "1")]),
        VcdVariable(("a", "b"), "whole", "integer", [(3, -2)]),
        VcdVariable((), "real", "real", [(7, 0.1)]),
        VcdVariable(("a",), "text", "text", [(3, "Größe 1"), (7, "")]),
        VcdVariable(("a",), "text", "text", [(6, "other")]),
    ]
    write_fst_file(tmp_path / "a.fst", variables, exponent=-6, begin=1)
    found = changes_of(tmp_path / "a.fst")
    assert found["a.b.wire"] == [(1, "0"), (3, "1"), (5, "0")]
    assert found["a.truth"] == [(1, "x"), (4, "1")]
    assert found["a.b.whole"] == [(1, "0" * 64), (3, "1" * 63 + "0")]
    assert [(time, float(value)) for time, value in found[".real"]] == [(1, 0.0), (7, 0.1)]
    assert found["a.text"] == [(1, ""), (3, "Größe 1"), (7, "")]
    assert found["a.text_2"] == [(1, ""), (6, "other")]


def test_a_run_as_fst(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """``--fst``: positions at the end of their ticks; the same bytes each time."""
    monkeypatch.chdir(tmp_path)
    Path("part.nc").write_text("G01 X10 F6000\nM30\n", "utf-8")
    for name in ("a.fst", "b.fst"):
        assert main(["run", "part.nc", "--fst", name, "--quiet"]) == 0
    assert Path("a.fst").read_bytes() == Path("b.fst").read_bytes()
    run = Controller().run("part.nc")
    changes = changes_of(Path("a.fst"))["signals.X.ACS.ACT_POS"]
    values = run.trace["X.ACS.ACT_POS"]
    changed = np.flatnonzero(np.diff(values, prepend=0.0))
    assert [time for time, _ in changes[1:]] == [(int(tick) + 1) * 1000 for tick in changed]
    assert [float(value) for _, value in changes[1:]] == pytest.approx(values[changed], rel=1e-12)
    assert main(["run", "part.nc", "--fst", "a.txt"]) == 2
