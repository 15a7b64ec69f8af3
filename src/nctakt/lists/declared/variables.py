# SPDX-License-Identifier: MIT
"""Variables lists (P-EXTV): declarations of V.E and V.CH variables and of their structures.

Their values become variables in ``variables.py``. Truth values may be written TRUE and FALSE here.
"""

from __future__ import annotations

from nctakt.base.dataclass import dataclass

#: Maximum length of V.E.name in characters; the controller may accept longer ones.
NAME_LENGTH = 26
#: Maximum length of a name, in characters.
MAX_NAME_LENGTH = 256
#: Inherited access rights.
INHERIT_ACCESS = "INHERIT_ACCESS"


@dataclass(frozen=True, slots=True)
class ScalarType:
    """A basic type: its size in bytes (0: in the list) and, for numbers, its range."""

    name: str
    size_bytes: int
    low: float = 0.0
    high: float = 0.0

    @property
    def is_numeric(self) -> bool:
        """Whether a realtime cycle can use it; it cannot use character strings."""
        return self.name not in {"STRING", "VSTRING"}

    @property
    def is_integer(self) -> bool:
        """Whether assignments round."""
        return self.is_numeric and self.name != "REAL64"


_LARGEST_REAL = 1.7976931348623157e308

#: All basic types by name.
SCALARS: dict[str, ScalarType] = {
    scalar.name: scalar
    for scalar in (
        ScalarType("BOOLEAN", 1, 0, 1),
        ScalarType("SGN08", 1, -128, 127),
        ScalarType("UNS08", 1, 0, 255),
        ScalarType("SGN16", 2, -32_768, 32_767),
        ScalarType("UNS16", 2, 0, 65_535),
        ScalarType("SGN32", 4, -2_147_483_648, 2_147_483_647),
        ScalarType("UNS32", 4, 0, 4_294_967_295),
        ScalarType("REAL64", 8, -_LARGEST_REAL, _LARGEST_REAL),
        ScalarType("STRING", 0),
        ScalarType("VSTRING", 0),
    )
}
