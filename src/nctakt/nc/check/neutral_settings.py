# SPDX-License-Identifier: MIT
"""Commands that are refused but for the values with which they change nothing.

In: checked commands of start sequences: ``#LAH``, ``#FILTER``, ``#TRANSVELMIN``, ``#TRC``. Out:
errors for settings refused by name, and notes on accepted ones.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from types import MappingProxyType

from nctakt.base.dataclass import dataclass, field
from nctakt.messages.programs.checked_blocks import INVALID_COMMAND_FORM
from nctakt.nc.check.expressions import ValueChecker
from nctakt.nc.check.findings import Findings
from nctakt.nc.check.path.path_commands import check_item
from nctakt.nc.meaning.path import Form, command_name, keywords
from nctakt.nc.tree import Bracket, Expression, HashCommand, Keyword, Number
from nctakt.nc.vocabulary import support_level
from nctakt.nc.vocabulary.entries import ACCEPTED


@dataclass(frozen=True, slots=True)
class Setting:
    """A command: its ``keywords`` with the bounds of the values that change nothing.

    ``words``: words without a value that change nothing. ``others``: further keywords of the
    command, all of which change something. ``pairs``: keywords that require another unless their
    value is 0. ``value``: the bounds of a value without a keyword. ``forms``: how the command is
    written.
    """

    keywords: Mapping[str, tuple[float, float]] = field(default_factory=dict)
    words: tuple[str, ...] = ()
    others: tuple[str, ...] = ()
    pairs: Mapping[str, str] = field(default_factory=dict)
    value: tuple[float, float] | None = None
    needs_bracket: bool = False
    forms: str = ""

    def is_neutral(self, item: Keyword | Expression) -> bool:
        """Return whether an item changes nothing."""
        if not isinstance(item, Keyword):
            return isinstance(item, Number) and _is_within(item.value, self.value)
        if item.value is None:
            return item.name in self.words
        return isinstance(item.value, Number) and _is_within(
            item.value.value, self.keywords.get(item.name)
        )


def _is_within(value: float, bounds: tuple[float, float] | None) -> bool:
    return bounds is not None and bounds[0] <= value <= bounds[1]


_ANY = (-1e300, 1e300)
_OFF = (0.0, 0.0)
_TRANSVELMIN = "#TRANSVELMIN ON [500]  |  #TRANSVELMIN ON  |  #TRANSVELMIN OFF"
_FILTER = Setting(
    MappingProxyType(
        {
            "ORDER": _ANY,
            "ORDER_TIME": _ANY,
            "SHARE": (0.0, 100.0),
            "AX_DEV": _ANY,
            "FCUT": _ANY,
            "ACC_FACT": (1.0, 10.0),
            "QUALITY": (0.0, 1.0),
        }
    ),
    forms="#FILTER ON [ORDER=10 SHARE=100]  |  #FILTER ON  |  #FILTER OFF",
)
SETTINGS = MappingProxyType(
    {
        "LAH": Setting(
            MappingProxyType({"SMOOTH_PATH_VEL": _OFF, "PROD_FACT": (0.0, 100.0)}),
            pairs=MappingProxyType({"SMOOTH_PATH_VEL": "PROD_FACT", "PROD_FACT": ""}),
            needs_bracket=True,
            forms="#LAH [SMOOTH_PATH_VEL=1 PROD_FACT=90]  |  #LAH [SMOOTH_PATH_VEL=0]",
        ),
        "FILTER": replace(_FILTER, needs_bracket=True),
        "FILTER ON": _FILTER,
        "FILTER OFF": _FILTER,
        "TRANSVELMIN ON": Setting(value=_OFF, forms=_TRANSVELMIN),
        "TRANSVELMIN OFF": Setting(forms=_TRANSVELMIN),
        "TRC": Setting(
            MappingProxyType(
                {
                    "G236_LIN": (0.0, 1.0),
                    "INVERSE": _OFF,
                    "KERF_MASKING": _OFF,
                    "ONLINE": _OFF,
                    "ONLINE_BY_VECTOR": (0.0, 1.0),
                    "PERPENDICULAR_RADIUS_CHANGE": _OFF,
                    "REMOVE_MASKED_BLOCKS": _OFF,
                    "TANGENTIAL_LIMIT": (0.1, 3.0),
                }
            ),
            words=("SPLIT_OFF",),
            others=("SPLIT", "SPLIT_PATH", "REMOVE_MASKED_BLOCKS"),
            needs_bracket=True,
            forms="#TRC [KERF_MASKING=0]  |  #TRC [SPLIT_OFF]",
        ),
    }
)


def check_setting(command: HashCommand, values: ValueChecker, findings: Findings) -> bool:
    """Check one of these commands; return false for any other."""
    name = command_name(command)
    setting = SETTINGS.get(name)
    if setting is None:
        return False
    bracket = command.arguments[0] if len(command.arguments) == 1 else None
    items = bracket.items if isinstance(bracket, Bracket) else ()
    is_written = isinstance(bracket, Bracket) if command.arguments else not setting.needs_bracket
    if not is_written or _lacks_pair(setting, command):
        findings.report(INVALID_COMMAND_FORM, command.span, command=f"#{name}", forms=setting.forms)
        return True
    form = Form((*setting.words, *setting.others), tuple(setting.keywords))
    for item in items:
        if isinstance(item, Keyword) or setting.value is None:
            check_item(form, f"#{name}", item, values, findings)
        else:
            values.value(item)
    entry = support_level.hash_command([word.name for word in command.words])
    assert entry is not None
    if all(setting.is_neutral(item) for item in items):
        entry = replace(entry, support=ACCEPTED)
    findings.report_support(entry, command.span, f"#{name}")
    return True


def _lacks_pair(setting: Setting, command: HashCommand) -> bool:
    """Return whether a keyword is missing the one that it requires."""
    given = {item.name: item for item in keywords(command)}
    for name, other in setting.pairs.items():
        item = given.get(name)
        if item is None:
            continue
        if not other and len(given) == 1:
            return True
        is_off = isinstance(item.value, Number) and item.value.value == 0.0
        if other and other not in given and not is_off:
            return True
    return False
