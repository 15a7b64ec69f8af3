# SPDX-License-Identifier: MIT
"""Options for the reading of rtconf.lis: the operating system's priorities, and rules.

In: the user's choices. Out: ``RtconfOptions`` with a ``Profile``. Source: manual 4.3, for INtime
the comment of the manual's example list, for Linux vendors' lists.
"""

from __future__ import annotations

from typing import Literal

from nctakt.base.dataclass import dataclass

Convention = Literal["auto", "table", "field"]


@dataclass(frozen=True, slots=True)
class Profile:
    """An operating system: the range of its priorities and their direction.

    ``reserved``: priorities inside the range that the system itself uses. ``settable_slice``:
    time_slice can be set. ``has_windows``: it shares the computer with Windows.
    """

    name: str
    title: str
    low: int
    high: int
    greatest_first: bool
    reserved: range
    settable_slice: bool
    has_windows: bool = True

    def urgency(self, priority: int) -> int:
        """Return the urgency of a priority: greater numbers run first."""
        return priority if self.greatest_first else -priority


PROFILES = {
    profile.name: profile
    for profile in (
        Profile("rtx", "RTX", 0, 127, True, range(125, 128), True),
        Profile("vxworks", "VxWorks", 0, 255, False, range(0), True),
        Profile("intime", "INtime", 0, 255, False, range(3), False),
        Profile("linux", "Linux", 1, 99, True, range(99, 100), False, has_windows=False),
    )
}


@dataclass(frozen=True, slots=True)
class RtconfOptions:
    """Choices beyond the list itself.

    ``convention``: the meaning of the numbers of interrupt_source (``auto``: by the line's
    comment). ``functions``: names of functions besides the controller's. ``small_windows_is_off``:
    a windows_time below time_slice is rounded down to 0, not up. ``ignore_windows``: no time is
    guaranteed to Windows. ``hal_timer_us``: the timer period of RTX. ``lenient``: errors by choice
    are warnings.
    """

    profile: Profile = PROFILES["rtx"]
    convention: Convention = "auto"
    functions: tuple[str, ...] = ()
    small_windows_is_off: bool = False
    ignore_windows: bool = False
    hal_timer_us: int | None = None
    lenient: bool = False


STANDARD_OPTIONS = RtconfOptions()
