# SPDX-License-Identifier: MIT
"""The numbers that say what something is or does in the realtime part: kinds, states, actions.

``codes.pxd`` has the same names as constants of C; ``scripts/constants`` writes it from this file.
The numbers of rows and cells stand in ``rows.py``.
"""

from __future__ import annotations

#: Stages of a segment (``path/geometry.py``), in the order in which the path passes them forward.
(
    BEFORE_STAGES,
    ENTRY_ZONE,
    MIDDLE,
    EXIT_ZONE,
    CURVE,
    BEHIND_STAGES,
) = range(-1, 5)
