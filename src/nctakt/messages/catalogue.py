# SPDX-License-Identifier: MIT
"""The declaration of messages, and the catalogue of all messages by number.

In: the declarations of the other modules here. Out: a ``Message`` for each, which is reported by
name, and the messages of a number, for users who ask for it.
"""

from __future__ import annotations

import copyreg
from collections.abc import Callable
from functools import cache, partial
from string import Formatter

from nctakt.base.diagnostics import Cases, Message, Severity, Wording
from nctakt.messages.placeholders import COMMON

#: The range of nctakt's own numbers; all others are the controller's.
FIRST_OWN, LAST_OWN = 900_000, 999_999

#: Classes of effect and of clearing: of most errors of the controller; of messages without.
USUAL_CLASSES, NO_CLASSES = (2, 3), (0, 0)

_declared: list[Message] = []
_own: set[int] = set()


def _declare(
    severity: Severity,
    number: int,
    /,
    *,
    en: str,
    de: str,
    remedy_en: str = "",
    remedy_de: str = "",
    cause_en: str = "",
    cause_de: str = "",
    classes: tuple[int, int] | None = None,
    known_as: tuple[int, ...] = (),
    cases: Cases | None = None,
    **parameters: tuple[str, str],
) -> Message:
    """Declare the message of a number; ``parameters`` explains the names in its texts, en and de.

    Names that a message does not explain have the meaning of ``placeholders.py``.
    Text and remedy are format strings; ``cause`` explains how the error comes about.
    ``classes`` are the controller's for the effect of an error and for clearing it
    (``classes.py``): those of most of its errors unless given, none for nctakt's own messages.
    ``known_as`` are other numbers of the same message: nctakt's own where the controller's leads,
    those of other documents.
    ``cases``: the numbers of a message that the controller numbers by case (``cases.py``).
    """
    if classes is None:
        is_usual = severity is Severity.ERROR and not is_own(number)
        classes = USUAL_CLASSES if is_usual else NO_CLASSES
    message = Message(
        number,
        severity,
        Wording((en, de), (remedy_en, remedy_de), (cause_en, cause_de)),
        partial(_explained, f"{en}{remedy_en}", parameters),
        classes,
        known_as,
        cases,
    )
    own = set(filter(is_own, message.numbers))
    assert own.isdisjoint(_own), number
    _own.update(own)
    _declared.append(message)
    return message


def _explained(texts: str, parameters: dict[str, tuple[str, str]]) -> dict[str, tuple[str, str]]:
    """Return the names in the texts of a message with their meanings, in their order."""
    names = dict.fromkeys(name for _, name, _, _ in Formatter().parse(texts) if name is not None)
    assert parameters.keys() <= names.keys(), sorted(parameters)
    return {name: parameters.get(name) or COMMON[name] for name in names}


error = partial(_declare, Severity.ERROR)
warning = partial(_declare, Severity.WARNING)
note = partial(_declare, Severity.NOTE)


@cache
def catalogue() -> tuple[Message, ...]:
    """Return all messages in the order of their numbers; imports their modules."""
    import importlib  # noqa: PLC0415 - who knows a message by its name needs neither
    import pkgutil  # noqa: PLC0415

    package = importlib.import_module(__package__)
    for module in pkgutil.walk_packages(package.__path__, f"{__package__}."):
        importlib.import_module(module.name)
    return tuple(sorted(_declared, key=lambda message: (message.id, message.known_as)))


def messages_of(number: int) -> tuple[Message, ...]:
    """Return the messages that have a number; first those that it leads."""
    having = [message for message in catalogue() if number in message.numbers]
    return tuple(sorted(having, key=lambda message: number not in message.leading))


def _find(number: int, text: str) -> Message:
    """Return the message of this number and English text."""
    return next(message for message in messages_of(number) if message.text.en == text)


def _by_text(message: Message) -> tuple[Callable[[int, str], Message], tuple[int, str]]:
    return _find, (message.id, message.text.en)


# A message goes to another process by its number and text: it is the same object there.
copyreg.pickle(Message, _by_text)


def is_own(number: int) -> bool:
    """Return whether a number is one of nctakt's, not one of the controller's."""
    return FIRST_OWN <= number <= LAST_OWN


def next_free_number() -> int:
    """Return the number for the next message: one above the highest of nctakt's own."""
    numbers = (number for message in catalogue() for number in message.numbers)
    return max(number for number in numbers if is_own(number)) + 1
