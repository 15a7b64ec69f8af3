# SPDX-License-Identifier: MIT
"""The text of a ``#MSG`` with conversions for values, as in ``"X = %f"``: its conversions in order.

Who fills them is ``decoder/values/texts.py``.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import NamedTuple

_CONVERSION = re.compile(
    r"%(?:%|[-+ 0]*\d{0,3}(?:\.\d{1,3})?(?P<kind>[diuxXocfeEgGs])|(?P<wrong>[-+ 0#]*[\d.]*.?))"
)


class Conversion(NamedTuple):
    """One place as it is written; ``is_valid`` is false where it is none that can be filled."""

    text: str
    is_valid: bool

    @property
    def takes_text(self) -> bool:
        """Whether a text fits, not only a number."""
        return self.text.endswith("s")


def conversions(text: str) -> Iterator[Conversion]:
    """Each place in the order of the text; ``%%`` is none but the sign itself."""
    for match in _CONVERSION.finditer(text):
        if match["kind"] is not None:
            yield Conversion(match[0], True)
        elif match["wrong"] is not None:
            yield Conversion(match[0], False)
