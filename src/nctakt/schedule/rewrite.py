# SPDX-License-Identifier: MIT
"""rtconf.lis rewritten: the values that count, with everything else that is in it.

In: the bytes of a list, the configuration wanted. Out: the bytes of a list with that configuration.
Comments, order, blanks, line ends and encoding stay. Entries without effect (unknown ones, earlier
ones for the same parameter, those that belong to nothing) become comments; missing entries come
after the others of their thread.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator

from nctakt.base.dataclass import dataclass
from nctakt.base.text import decode_text, encode_text
from nctakt.lists.declared.rtconf import InterruptSource, RtconfConfiguration
from nctakt.lists.declared.schemas import RTCONF
from nctakt.lists.format.entries import read_entries
from nctakt.lists.format.parameter import Value, ValueType, shown, with_indices
from nctakt.lists.format.reader import BLANKS, Entry
from nctakt.lists.format.value_text import read_string, read_word
from nctakt.lists.format.values import Key, Values
from nctakt.lists.machine.schedules.scheduling_profile import Convention
from nctakt.messages import Collector
from nctakt.messages.machines.lists import LIST_WITHOUT_END
from nctakt.schedule.effective_table import effective_entries, effective_values

_LINE_END = re.compile(r"\r\n|\n|\r")
_END_OF_FILE = "\x1a"
_SOURCE: Key = ("interrupt_source", ())
#: Entry written if nothing says what starts the NC cycles; the comment makes it unambiguous.
_TIMER_ENTRY = "interrupt_source 2 # 1: hardware interrupt, 2: timer, 3: semaphore"
_FIELD_TIMER_ENTRY = "interrupt_source 1 # 1: timer, 2: hardware interrupt, 3: semaphore"
_PLAIN_STRING = re.compile(r"[^\s#(\"/]+")


@dataclass(frozen=True, slots=True)
class RewrittenList:
    """A list as bytes; how many entries were corrected, made a comment, added."""

    data: bytes
    corrected: int
    commented: int
    added: int

    @property
    def is_changed(self) -> bool:
        """Return whether it differs from the list before."""
        return bool(self.corrected or self.commented or self.added)


def rewrite(
    file: str,
    data: bytes,
    values: Values,
    configuration: RtconfConfiguration,
    required: Collection[str],
    convention: Convention = "auto",
) -> RewrittenList:
    """Return the list rewritten for ``configuration``.

    ``values``: those of the present list. ``required``: the names of entries that are added where
    they are missing. ``convention``: the meaning of the numbers of interrupt_source.
    """
    timer = _FIELD_TIMER_ENTRY if convention == "field" else _TIMER_ENTRY
    return _Rewriting(file, data, values, configuration, required, timer).result()


class _Rewriting:
    def __init__(
        self,
        file: str,
        data: bytes,
        values: Values,
        configuration: RtconfConfiguration,
        required: Collection[str],
        timer_entry: str,
    ) -> None:
        self._timer_entry = timer_entry
        self._data = data
        self._values = values
        self._source = configuration.interrupt_source
        self._effective = effective_values(configuration)
        self._required = required
        findings = Collector()
        self._entries = read_entries(file, data, RTCONF, findings)
        self._has_end = all(
            finding.message is not LIST_WITHOUT_END for finding in findings.diagnostics
        )
        self._counting = effective_entries(file, data)
        self._keys = {entry.key_span.line: key for key, entry in self._counting.items()}

    def result(self) -> RewrittenList:
        """Return the rewritten list."""
        text, mark, tail = decode_text(self._data).text.partition(_END_OF_FILE)
        ends = _LINE_END.findall(text)
        usual = ends[0] if ends else "\n"
        lines = _LINE_END.split(text)
        if not lines[-1]:
            lines.pop()
        ends += [usual] * (len(lines) - len(ends))
        corrected = commented = 0
        for entry in self._entries:
            line = self._line_of(entry)
            commented += line is None
            corrected += line not in (None, entry.line)
            lines[entry.key_span.line - 1] = f"# {entry.line.strip()}" if line is None else line
        added = sorted(self._additions(len(lines)), key=lambda addition: addition[0], reverse=True)
        # From the last to the first, so that the places of the others stay valid.
        for index, line in added:
            lines.insert(index, line)
            ends.insert(index, usual)
        counts = (corrected, commented, len(added))
        if not any(counts):
            return RewrittenList(self._data, *counts)
        body = "".join(line + end for line, end in zip(lines, ends, strict=True))
        return RewrittenList(encode_text(body + mark + tail, self._data), *counts)

    def _line_of(self, entry: Entry) -> str | None:
        """Return the new line of an entry; ``None`` if it has no effect."""
        key = self._keys.get(entry.key_span.line)
        if key is None or key not in self._effective:
            return None
        written = self._values.entry_values.get(key)
        if key == _SOURCE:
            return entry.line if written is not None else self._timer_entry
        value = self._effective[key]
        if key[0] == "external_object_name" and value == "":
            return None
        line = entry.line
        if written is None or written.value != value:
            line = _with_value(entry, key, value)
        name = with_indices(*key)
        if entry.path != name:
            begin, end = entry.key_span.column - 1, entry.key_span.end_column - 1
            line = line[:begin] + name + line[end:]
        return line

    def _additions(self, line_count: int) -> Iterator[tuple[int, str]]:
        """Yield lines to add, each with the place of the line that it comes before."""
        if not self._has_end:
            yield line_count, "End"
        for key, value in reversed(self._effective.items()):
            name = with_indices(*key)
            if key in self._counting or name not in self._required or value == "":
                continue
            if key != _SOURCE:
                yield self._place_of(key), f"{name} {_text_of(value)}"
            elif self._source is InterruptSource.TIMER:
                yield self._place_of(key), self._timer_entry

    def _place_of(self, key: Key) -> int:
        """Return before which line an entry is added: after those of the same element."""
        pattern, indices = key
        element = pattern.split("[]")[0]
        lines = [
            entry.key_span.line
            for (other, others), entry in self._counting.items()
            if others[:1] == indices[:1] and other.split("[]")[0] == element
        ]
        if indices and lines:
            return max(lines)
        return min((entry.key_span.line for entry in self._entries), default=1) - 1


def _with_value(entry: Entry, key: Key, value: Value) -> str:
    """Return the line of an entry with another value, its comment after it."""
    declared = RTCONF.find(key[0])
    assert declared is not None
    read = read_string if declared[0].type is ValueType.STRING else read_word
    word = read(entry, Collector())
    line = entry.line
    if word is None:
        end = entry.key_span.end_column - 1
        return f"{line[:end]} {_text_of(value)}{line[end:]}".rstrip()
    begin, end = word.span.column - 1, word.span.end_column - 1
    blank = "" if begin and line[begin - 1] in BLANKS else " "
    return f"{line[:begin]}{blank}{_text_of(value)}{line[end:]}"


def _text_of(value: Value) -> str:
    """Return a value as the list writes it; character strings in quotation marks if they must."""
    if isinstance(value, str) and not _PLAIN_STRING.fullmatch(value) and '"' not in value:
        return f'"{value}"'
    return shown(value)
