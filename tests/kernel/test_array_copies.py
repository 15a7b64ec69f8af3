# SPDX-License-Identifier: MIT
"""The content of arrays as a snapshot keeps it: all of it, however often it is put back."""

from __future__ import annotations

import pytest

from nctakt.kernel.state import ArrayCopies, PlainArrayCopies


@pytest.mark.parametrize("kind", [ArrayCopies, PlainArrayCopies], ids=["in_force", "plain"])
def test_content_comes_back_until_it_is_taken_again(kind: type[PlainArrayCopies]) -> None:
    """Arrays of any length keep their places; what was taken last is put back."""
    arrays = [bytearray(b"first"), bytearray(), bytearray(b"second")]
    views = [memoryview(one) for one in arrays]
    kept = kind(arrays)
    for _ in range(2):
        arrays[0][:], arrays[2][:] = b"other", b"spoilt"
        kept.put_back()
        assert [bytes(one) for one in views] == [b"first", b"", b"second"]
    arrays[2][:] = b"latest"
    kept.take()
    arrays[0][:], arrays[2][:] = b"other", b"spoilt"
    kept.put_back()
    assert [bytes(one) for one in views] == [b"first", b"", b"latest"]


@pytest.mark.parametrize("kind", [ArrayCopies, PlainArrayCopies], ids=["in_force", "plain"])
def test_what_cannot_be_written_is_refused(kind: type[PlainArrayCopies]) -> None:
    """Memory that is read only, or none at all, is no array."""
    with pytest.raises((TypeError, BufferError)):
        kept = kind([b"read only"])  # type: ignore[list-item]
        kept.put_back()
