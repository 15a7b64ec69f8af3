# SPDX-License-Identifier: MIT
"""The inputs of an exported FMU, which its states need, in a temporary file."""

from __future__ import annotations

import errno
import io
import tempfile

import pytest

from nctakt.base.failure import Failure
from nctakt.fmu.cell_state import CellInputs

#: Inputs that wait in memory until they are written together.
TOGETHER = 4096


class FullDisk(io.BytesIO):
    """A temporary file on a disk without room."""

    def write(self, _data: object, /) -> int:
        raise OSError(errno.ENOSPC, "No space left on device")


def test_a_full_disk_is_reported(monkeypatch: pytest.MonkeyPatch) -> None:
    """902840 with what the system says, at the input that does not fit; closing is harmless."""
    monkeypatch.setattr(tempfile, "SpooledTemporaryFile", lambda _size: FullDisk())
    inputs = CellInputs()
    for tick in range(TOGETHER - 1):
        inputs.note(tick, 7, 1.5)
    with pytest.raises(Failure) as failed:
        inputs.note(TOGETHER - 1, 7, 1.5)
    (reported,) = failed.value.diagnostics
    assert reported.id == 902840
    assert "No space left on device" in reported.text("en")
    assert "TMPDIR" in reported.remedy("en")


def test_inputs_come_back_as_they_were() -> None:
    """Those in the file and those that wait, in their order; a later run has the first of them."""
    inputs = CellInputs()
    for tick in range(TOGETHER + 2):
        inputs.note(tick, 7, tick / 4)
    assert len(inputs) == TOGETHER + 2
    rows = [row for part in inputs.parts(TOGETHER + 1) for row in part.tolist()]
    assert rows == [[tick, 7, tick / 4] for tick in range(TOGETHER + 1)]
    again = CellInputs(inputs, 2)
    again.note(9, 8, 0.5)
    assert [part.tolist() for part in again.parts(3)] == [[[0, 7, 0], [1, 7, 0.25]], [[9, 8, 0.5]]]
