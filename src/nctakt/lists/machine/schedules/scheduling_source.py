# SPDX-License-Identifier: MIT
"""The meaning of the numbers of interrupt_source (P-RTCF-00001).

In: the number, the comment of its line, the chosen convention. Out: the meaning and the reason. The
manual contradicts itself: its table (3.1) has 1 hardware and 2 timer, the comments of its example
lists the other way round. So a comment that explains the numbers decides, otherwise the table does.
"""

from __future__ import annotations

import re

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Text
from nctakt.lists.declared.rtconf import INTERRUPT_SOURCES, InterruptSource
from nctakt.lists.format.reader import BLANKS, Entry
from nctakt.lists.machine.schedules.scheduling_profile import Convention

#: Words in the comments of lists in the field.
FIELD_SOURCES = {
    1: InterruptSource.TIMER,
    2: InterruptSource.HARDWARE,
    3: InterruptSource.SEMAPHORE,
    4: InterruptSource.OUTSIDE,
}
_NAMES = {
    InterruptSource.HARDWARE: Text("hardware interrupt", "Hardware-Interrupt"),
    InterruptSource.TIMER: Text("timer", "Timer"),
    InterruptSource.SEMAPHORE: Text("semaphore", "Semaphor"),
    InterruptSource.OUTSIDE: Text("external scheduling", "externes Scheduling"),
}

_CONVENTIONS: dict[Convention, dict[int, InterruptSource]] = {
    "field": FIELD_SOURCES,
    "table": INTERRUPT_SOURCES,
}
_AS_SAID = Text("as the comment says", "wie der Kommentar sagt")
#: Maximum length of a comment without a number that explains its own line, in words.
_FEW_WORDS = 3

_PAIR = re.compile(r"(?<![\w.])([0-4])(?!\w)\s*(?:==|=|:|-|\))?\s*(?=[^\W\d_])")
_NEGATION = re.compile(r"\b(?:not|no|nicht|keine?|statt|instead)\b")
_TIMER = re.compile(r"timer|\bintern")
_EXTERN = re.compile(r"\bextern")
_HARDWARE = re.compile(r"\b(?:irq|isr|hw)\b|interrupt|hardware|sercos|\bextern")


@dataclass(frozen=True, slots=True)
class SourceReading:
    """The meaning of a number, its convention, and the reason."""

    source: InterruptSource
    convention: Convention
    reason: Text

    @property
    def text(self) -> Text:
        """The meaning and the reason as text."""
        name, reason = _NAMES[self.source], self.reason
        return Text(
            f"{name.en} (convention '{self.convention}', {reason.en})",
            f"{name.de} (Konvention '{self.convention}', {reason.de})",
        )


def comment_of(entry: Entry) -> str:
    """Return the comment after a number."""
    words = entry.rest.strip(BLANKS).split(None, 1)
    return words[1].strip(BLANKS) if len(words) > 1 else ""


def read_source(number: int, comment: str, convention: Convention) -> SourceReading:
    """Return the meaning of 1 to 4."""
    if convention != "auto":
        table = INTERRUPT_SOURCES if convention == "table" else FIELD_SOURCES
        return SourceReading(table[number], convention, Text("as chosen", "wie gewählt"))
    judged, reason = _judge(number, comment)
    table = INTERRUPT_SOURCES if judged == "table" else FIELD_SOURCES
    return SourceReading(table[number], judged, reason)


def _judge(number: int, comment: str) -> tuple[Convention, Text]:
    """Return the convention of the comment of a line with ``number``, and the reason."""
    text = _without_signs(comment)
    matches = list(_PAIR.finditer(text))
    if not text:
        return "table", Text("the line has no comment", "die Zeile hat keinen Kommentar")
    if not matches:
        if len(text.split()) <= _FEW_WORDS and (meaning := _meaning(text)) is not None:
            for convention, table in _CONVENTIONS.items():
                if table[number] is meaning:
                    return convention, _AS_SAID
        quoted = comment.replace("{", "(").replace("}", ")")
        return "table", Text(
            f"the comment '{quoted}' explains no number",
            f"der Kommentar '{quoted}' erklärt keine Zahl",
        )
    meanings: dict[int, set[InterruptSource | None]] = {}
    for index, match in enumerate(matches):
        until = matches[index + 1].start() if index + 1 < len(matches) else len(text)
        label = re.split(r"[,;|]", text[match.end() : until])[0]
        meanings.setdefault(int(match[1]), set()).add(_meaning(label))
    if meanings.get(3, {InterruptSource.SEMAPHORE}) == {InterruptSource.SEMAPHORE}:
        listed = {number: meanings[number] for number in (1, 2) if number in meanings}
        for convention, table in _CONVENTIONS.items():
            if listed and all(listed[number] == {table[number]} for number in listed):
                return convention, _AS_SAID
    return "table", Text("the comment is unclear", "der Kommentar ist unklar")


def _without_signs(comment: str) -> str:
    """Return the comment in small letters without its opening and closing signs."""
    text = comment.casefold().strip(BLANKS)
    for opener, closer in (("(", ")"), ("/*", "*/")):
        if text.startswith(opener):
            return text.removeprefix(opener).removesuffix(closer).strip(BLANKS)
    return text.lstrip("#").strip(BLANKS)


def _meaning(label: str) -> InterruptSource | None:
    """Return the meaning of a label; ``None`` if it is unclear, or external scheduling."""
    if "schedul" in label or _NEGATION.search(label):
        return None
    if "sema" in label:
        return InterruptSource.SEMAPHORE
    if _TIMER.search(label):
        return None if _EXTERN.search(label) else InterruptSource.TIMER
    return InterruptSource.HARDWARE if _HARDWARE.search(label) else None
