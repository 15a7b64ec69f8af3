# SPDX-License-Identifier: MIT
"""Articles about the interface as the controller names it: elements, structures, blocks, constants.

In: the table of the interface (``hli/table.py``). Out: an article for each row of it; a path is
found with any indices, with names of the older generation, down to members of structures.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from functools import cache

from nctakt.base.diagnostics import Text
from nctakt.base.failure import Failure
from nctakt.hli import table
from nctakt.reference.article import Article, Fact, Topic, fact

_ELEMENT = Text("element of the interface to the PLC", "Element der Schnittstelle zur SPS")
_STRUCTURE = Text("structure of the interface to the PLC", "Struktur der Schnittstelle zur SPS")
_CONSTANT = Text("constant of the PLC's library", "Konstante der SPS-Bibliothek")
_BLOCK = Text("function block of the PLC's library", "Funktionsbaustein der SPS-Bibliothek")

_WRITERS: Mapping[str, Text] = {
    "PLC": Text("the PLC", "die SPS"),
    "CNC": Text("the CNC", "die CNC"),
    "both": Text("the PLC and the CNC", "die SPS und die CNC"),
}
_HANDSHAKES: Mapping[str, Text] = {
    "level": Text(
        "level: command_w counts while enable_w is TRUE, else what the HMI asks for",
        "Pegel: command_w gilt, solange enable_w TRUE ist, sonst der Wunsch der HMI",
    ),
    "edge": Text("its rising edge counts", "ihre steigende Flanke gilt"),
    "semaphore": Text(
        "semaphore: write while it is FALSE, then set it; the other side clears it",
        "Semaphor: schreiben, solange es FALSE ist, dann setzen; die Gegenseite löscht es",
    ),
    "please, done": Text(
        "please_rw: new; done_w := TRUE acknowledges", "please_rw: neu; done_w := TRUE quittiert"
    ),
    "alive": Text("sign of life: set by the PLC, cleared by the CNC", "Lebenszeichen der SPS"),
}
_SURE: Mapping[str, Text] = {
    "inferred": Text("place or type is inferred", "Ort oder Typ ist erschlossen"),
    "ours": Text(
        "in no public source: the name is nctakt's own",
        "in keiner öffentlichen Quelle: der Name ist von nctakt",
    ),
}
_KNOWN = Text("known, without effect here", "bekannt, hier ohne Wirkung")
_ACTS = Text("acts", "wirkt")
_SHOWN = Text("shows what waits or is in effect", "zeigt, was wartet oder wirkt")
_UNSERVED = Text("known, has no value here", "bekannt, hat hier keinen Wert")
_FACT = Text("shows a fact about the machine", "zeigt eine Angabe zur Maschine")


def _element(element: table.Element, name: str = "") -> Article:
    return Article(name or element.path, _kind(element), _meaning(element), tuple(_facts(element)))


def _kind(element: table.Element) -> Text:
    return _STRUCTURE if element.said is None else _ELEMENT


def _meaning(element: table.Element) -> Text:
    rows = [row.meaning for row in (element.row, element.inner) if row is not None]
    if not rows:
        return Text("part of the interface", "Teil der Schnittstelle")
    return Text("; ".join(row.en for row in rows), "; ".join(row.de for row in rows))


def _facts(element: table.Element) -> Iterator[Fact]:
    type_ = element.type
    yield fact("Type", "Typ", _bytes(f"{type_.name}, {type_.size_bytes} byte"))
    if type_.members:
        yield fact("Members", "Elemente", ", ".join(one.name for one in type_.members))
    if element.unit:
        yield fact("Unit", "Einheit", element.unit)
    said = element.said
    if said is not None:
        if said.range:
            yield fact("Values", "Werte", _values(said.range))
        yield fact("Written by", "Geschrieben von", _WRITERS[element.by])
        handshake = said.handshake or (element.row.handshake if element.row else "")
        if handshake:
            yield fact("Handshake", "Handschlag", _HANDSHAKES[handshake])
    yield fact("Effect", "Wirkung", _effect(element))
    if said is not None and said.sure:
        yield fact("Source", "Quelle", _SURE[said.sure])
    yield fact("Place", "Stelle", _bytes(f"{element.root}, byte {element.offset}"))
    older = [name for name, path in table.aliases().items() if path == element.pattern]
    if older:
        yield fact("Older names", "Ältere Namen", ", ".join(older))


def _bytes(text: str) -> Text:
    """Return a text with numbers of bytes."""
    return Text(text, text.replace(" byte", " Byte"))


def _effect(element: table.Element) -> Text:
    tie = element.tie
    if tie is not None and tie.kind == table.UNSERVED:
        return _UNSERVED
    if element.effect == table.KNOWN:
        return _KNOWN
    if tie is None:
        return Text("see its parts", "siehe seine Teile")
    if tie.kind == "fact":
        return _FACT
    if tie.name in table.MANAGED:
        return _ACTS if element.effect == table.ACTS else _SHOWN
    name = f"…{tie.name}" if element.root == "gpAx" or "coord_r" in element.path else tie.name
    if tie.factor != 1:
        name += f" × {tie.factor}"
    elif tie.equal is not None:
        name += f" = {tie.equal}"
    elif tie.unequal is not None:
        name += f" ≠ {tie.unequal}"
    spindle = Text(" (spindles)", " (Spindeln)") if tie.for_spindles else Text("", "")
    if element.effect == table.ACTS:
        return Text(f"acts on {name}{spindle.en}", f"wirkt auf {name}{spindle.de}")
    return Text(f"shows {name}{spindle.en}", f"zeigt {name}{spindle.de}")


def _values(text: str) -> str:
    """Return a range, or the constants of a group with their numbers."""
    named = [one for one in table.constants().values() if one.group == text]
    return ", ".join(f"{one.value} {one.name}" for one in named) if named else text


def _structure(type_: table.DataType) -> Article:
    lines = [f"{one.offset} {one.name}: {one.type.name}" for one in type_.members]
    facts = [
        fact("Size", "Größe", _bytes(f"{type_.size_bytes} byte")),
        fact("Members", "Elemente", "\n".join(lines)),
    ]
    meaning = Text("its members with their places in bytes", "ihre Elemente mit ihren Bytestellen")
    return Article(type_.name, _STRUCTURE, meaning, tuple(facts))


def _constant(constant: table.Constant) -> Article:
    facts = [fact("Group", "Gruppe", constant.group)]
    if constant.value is not None:
        facts.insert(0, fact("Value", "Wert", constant.value))
    return Article(constant.name, _CONSTANT, constant.meaning, tuple(facts))


def _block(block: table.Block) -> Article:
    def pins(pairs: tuple[tuple[str, str], ...]) -> str:
        return ", ".join(f"{name} {type_}" for name, type_ in pairs)

    kinds = (
        ("In and out", "Ein und Aus", block.in_out),
        ("Inputs", "Eingänge", block.inputs),
        ("Outputs", "Ausgänge", block.outputs),
    )
    facts = [fact(en, de, pins(pairs)) for en, de, pairs in kinds if pairs]
    return Article(block.name, _BLOCK, block.meaning, tuple(facts))


@cache
def _elements() -> Mapping[str, table.Element]:
    """Return the elements that have a separate row, by their paths without numbers."""
    return {
        path: element
        for path, element in table.patterns().items()
        if element.row is not None and element.inner is None
    }


def _all() -> Iterator[Article]:
    for path, element in _elements().items():
        yield _element(element, path)
    for type_ in table.structures():
        yield _structure(type_)
    for constant in table.constants().values():
        yield _constant(constant)
    for block in table.blocks().values():
        yield _block(block)


def is_path(word: str) -> bool:
    """Return whether a word is meant for a path of the interface."""
    return "^" in word and re.match(r"\s*(HLI_Global_Variables\.)?[gp]\w+", word, re.I) is not None


def _find(word: str) -> tuple[Article, ...]:
    """Return the article of a path, of an element by its last name, or of another row."""
    if is_path(word):
        listed = {path.lower(): path for path in _elements()}.get(word.lower())
        if listed is not None:
            return (_element(_elements()[listed], listed),)
        try:
            return (_element(table.find(word)),)
        except Failure:
            return ()
    name = word.lower()
    found = [
        _element(element, path)
        for path, element in _elements().items()
        if path.rpartition(".")[2].removesuffix("[]").lower() == name
    ]
    found += (_structure(one) for one in table.structures() if one.name.lower() == name)
    found += (_constant(one) for one in table.constants().values() if one.name.lower() == name)
    found += (_block(one) for one in table.blocks().values() if one.name.lower() == name)
    return tuple(found)


def _names() -> Iterator[str]:
    for path in _elements():
        yield path.rpartition(".")[2].removesuffix("[]")
    for type_ in table.structures():
        yield type_.name
    yield from table.constants()
    yield from table.blocks()


ELEMENTS = Topic(
    "elements",
    Text(
        "The interface as the controller names it (gpCh, gpAx)",
        "Die Schnittstelle, wie die Steuerung sie nennt (gpCh, gpAx)",
    ),
    ("gpCh[0]^.bahn_state.program_end_r", "MC_CONTROL_BOOL_UNIT", "MC_Power"),
    _all,
    _find,
    _names,
)
