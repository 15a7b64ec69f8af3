# SPDX-License-Identifier: MIT
"""How rtconf.lis is to be read: the operating system's priorities, and the choices of the rules.

In: what the user chose. Out: ``RtconfOptions`` with a ``Profile``. Source: manual 4.3, for INtime
the comment of the manual's example list; Linux is that of vendors' lists.
"""

from __future__ import annotations

from typing import Literal

from nctakt.base.dataclass import dataclass

Convention = Literal["auto", "table", "field"]


@dataclass(frozen=True, slots=True)
class Profile:
    """An operating system: the range of its priorities and their direction.

    ``reserved`` are priorities inside the range that the system itself needs.
    ``settable_slice``: time_slice can be set there. ``has_windows``: it runs beside Windows.
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
        """Return a number that is the greater, the earlier a thread comes."""
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
    """Choices that the list itself does not make.

    ``convention``: what the numbers of interrupt_source mean (``auto``: what the line's comment
    says). ``functions``: names of functions beside the controller's. ``small_windows_is_off``: a
    windows_time below time_slice is rounded down to 0, not up. ``ignore_windows``: no time is
    guaranteed to Windows. ``hal_timer_us``: the period that RTX is set to. ``lenient``: what is
    an error only by our choice is a warning.
    """

    profile: Profile = PROFILES["rtx"]
    convention: Convention = "auto"
    functions: tuple[str, ...] = ()
    small_windows_is_off: bool = False
    ignore_windows: bool = False
    hal_timer_us: int | None = None
    lenient: bool = False


STANDARD_OPTIONS = RtconfOptions()
