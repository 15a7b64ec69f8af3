# SPDX-License-Identifier: MIT
"""The conversions in the text of a ``#MSG``, such as ``%f`` in ``"X = %f"``.

``decoder/values/texts.py`` fills them in.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import NamedTuple

_CONVERSION = re.compile(
    r"%(?:%|[-+ 0]*\d{0,3}(?:\.\d{1,3})?(?P<kind>[diuxXocfeEgGs])|(?P<wrong>[-+ 0#]*[\d.]*.?))"
)


class Conversion(NamedTuple):
    """One conversion as written; ``is_valid`` is false for one that cannot be filled in."""

    text: str
    is_valid: bool

    @property
    def takes_text(self) -> bool:
        """Whether it accepts a text as well as a number."""
        return self.text.endswith("s")


def conversions(text: str) -> Iterator[Conversion]:
    """Yield the conversions of a text in their order; ``%%`` is the sign itself."""
    for match in _CONVERSION.finditer(text):
        if match["kind"] is not None:
            yield Conversion(match[0], True)
        elif match["wrong"] is not None:
            yield Conversion(match[0], False)
