# SPDX-License-Identifier: MIT
"""The device that an MTConnect agent shows: its data items, and its description in XML.

In: a machine. Out: data items, each with the values of the session that it needs and the text that
is sent; the description, which an agent of version 2 takes from the adapter. Values unknown to the
controller are UNAVAILABLE: spindles that the PLC turns.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from xml.etree import ElementTree

from nctakt.base.dataclass import dataclass
from nctakt.lists.machine.machine import Machine
from nctakt.servers.catalogue import Catalogue
from nctakt.servers.hli_values import Part, parts_of
from nctakt.servers.store import Scalar
from nctakt.session.listening import Frame

UNAVAILABLE = "UNAVAILABLE"

#: The states of ``HLI.STATE``: ready, running, error, reset.
_READY, _RUNNING, _ERROR, _RESET = range(4)

#: Function for the text of an item: takes the latest values, and the latest frame, if there is one.
Show = Callable[[Mapping[str, Scalar], Frame | None], str]


@dataclass(frozen=True, slots=True)
class DataItem:
    """A data item: its key, category, type, further attributes, and where it belongs.

    ``part``: channel, axis or spindle, ``None`` for the device. ``needs``: names of the session.
    """

    key: str
    category: str
    type: str
    attributes: Mapping[str, str]
    part: Part | None
    needs: tuple[str, ...]
    show: Show


def data_items(machine: Machine, catalogue: Catalogue) -> list[DataItem]:
    """Return the data items of a machine."""
    items = [
        DataItem("avail", "EVENT", "AVAILABILITY", {}, None, (), lambda *_: "AVAILABLE"),
        DataItem("message", "EVENT", "MESSAGE", {}, None, (), lambda *_: f"|{UNAVAILABLE}"),
    ]
    for part in parts_of(machine, catalogue):
        items += {"channel": _channel, "axis": _axis, "spindle": _spindle}[part.kind](part)
    return items


# --- channels -------------------------------------------------------------------------------------


def _channel(part: Part) -> Iterator[DataItem]:
    """Yield the items of a path."""
    path, names = f"p{part.name}", part.names
    switches = {"single_block": "SINGLE_BLOCK", "optional_stop": "OPTIONAL_STOP"}

    def item(
        key: str, category: str, type_: str, show: Show, *needs: str, **attributes: str
    ) -> DataItem:
        own = tuple(names[name] for name in needs)
        return DataItem(f"{path}_{key}", category, type_, attributes, part, own, show)

    def value(name: str) -> Show:
        return lambda values, _: number(values.get(names[name]))

    yield item(
        "execution",
        "EVENT",
        "EXECUTION",
        lambda values, _: _execution({name: values.get(names[name], 0) for name in _EXECUTION}),
        *_EXECUTION,
    )
    yield item("mode", "EVENT", "CONTROLLER_MODE", lambda *_: "AUTOMATIC")
    for name, sub_type in switches.items():
        on = _switch(names[name])
        yield item(name, "EVENT", "CONTROLLER_MODE_OVERRIDE", on, name, subType=sub_type)
    yield item("program", "EVENT", "PROGRAM", lambda _, frame: _block(frame, part.channel, "file"))
    yield item(
        "line",
        "EVENT",
        "LINE_NUMBER",
        lambda _, frame: _block(frame, part.channel, "line"),
        subType="ABSOLUTE",
    )
    speed = {"subType": "ACTUAL", "units": "MILLIMETER/SECOND"}
    yield item("feed", "SAMPLE", "PATH_FEEDRATE", value("path_speed"), "path_speed", **speed)
    yield item(
        "override",
        "EVENT",
        "PATH_FEEDRATE_OVERRIDE",
        value("override_total"),
        "override_total",
        subType="PROGRAMMED",
    )
    yield item("logic", "CONDITION", "LOGIC_PROGRAM", _condition(names["error"]), "error")


_EXECUTION = ("state", "paused", "armed", "feed_hold")


def _execution(lamps: Mapping[str, Scalar]) -> str:
    """Return the state of a path in the words of the standard."""
    if lamps["state"] == _ERROR:
        return "STOPPED"
    if lamps["state"] == _RESET:
        return "PROGRAM_STOPPED"
    if lamps["state"] != _RUNNING:
        return "READY"
    if lamps["paused"] or lamps["armed"]:
        return "INTERRUPTED"
    return "FEED_HOLD" if lamps["feed_hold"] else "ACTIVE"


def _switch(name: str) -> Show:
    return lambda values, _: "ON" if values.get(name) else "OFF"


def _condition(name: str) -> Show:
    """Return the condition of a path: a fault with the number of the error, or normal."""

    def show(values: Mapping[str, Scalar], _: Frame | None) -> str:
        error = int(float(values.get(name, 0)))
        return f"FAULT|{error}|||error {error}" if error else "NORMAL||||"

    return show


def _block(frame: Frame | None, channel: int, what: str) -> str:
    """Return file or line of the current block of a channel."""
    span = None if frame is None else frame.blocks.get(channel)
    if span is None:
        return UNAVAILABLE
    return span.file.replace("|", " ") if what == "file" else str(span.line)


# --- axes and spindles ----------------------------------------------------------------------------


def _axis(part: Part) -> Iterator[DataItem]:
    """Yield the positions of an axis."""
    type_, units = ("POSITION", "MILLIMETER") if part.is_linear else ("ANGLE", "DEGREE")
    for name, sub_type in (("actual", "ACTUAL"), ("command", "COMMANDED")):
        attributes = {"subType": sub_type, "units": units}
        key = f"p{part.channel}_{part.name}_{name}"
        yield _sample(key, type_, attributes, part, part.names[name])


def _spindle(part: Part) -> Iterator[DataItem]:
    """Yield the speed of a spindle."""
    attributes = {"subType": "ACTUAL", "units": "REVOLUTION/MINUTE"}
    key = f"p{part.channel}_{part.name}_speed"
    if part.is_known:
        yield _sample(key, "ROTARY_VELOCITY", attributes, part, part.names["speed"])
    else:
        yield DataItem(
            key, "SAMPLE", "ROTARY_VELOCITY", attributes, part, (), lambda *_: UNAVAILABLE
        )


def _sample(key: str, type_: str, attributes: Mapping[str, str], part: Part, name: str) -> DataItem:
    return DataItem(
        key,
        "SAMPLE",
        type_,
        attributes,
        part,
        (name,),
        lambda values, _: number(values.get(name)),
    )


def number(value: Scalar | None) -> str:
    """Return a number as sent."""
    return UNAVAILABLE if value is None else f"{float(value):.10g}"


# --- the description ------------------------------------------------------------------------------


def describe_device(machine: Machine, items: list[DataItem]) -> str:
    """Return the ``Device`` of the standard for a machine."""
    name = machine.name or "machine"
    device = ElementTree.Element("Device", id="d", name=name, uuid=f"nctakt-{name}")
    ElementTree.SubElement(device, "Description", manufacturer="nctakt")
    items_of: dict[tuple[str, int, str] | None, ElementTree.Element] = {}
    items_of[None] = ElementTree.SubElement(device, "DataItems")
    components = ElementTree.SubElement(device, "Components")
    axes = _component(components, "Axes", "axes", "axes")
    paths = _component(components, "Controller", "controller", "controller")
    axes, paths = (ElementTree.SubElement(parent, "Components") for parent in (axes, paths))
    for item in items:
        part = item.part
        key = None if part is None else part.key
        if part is not None and key not in items_of:
            parent = paths if part.kind == "channel" else axes
            name = f"path{part.name}" if part.kind == "channel" else part.name
            id_ = f"c{part.channel}_{part.kind}_{part.name}"
            element = _component(parent, _component_type(part), id_, name)
            items_of[key] = ElementTree.SubElement(element, "DataItems")
        attributes = {"category": item.category, "id": item.key, "name": item.key}
        attributes |= {"type": item.type, **item.attributes}
        ElementTree.SubElement(items_of[key], "DataItem", attributes)
    return ElementTree.tostring(device, encoding="unicode")


def _component(parent: ElementTree.Element, type_: str, id_: str, name: str) -> ElementTree.Element:
    return ElementTree.SubElement(parent, type_, id=id_, name=name)


def _component_type(part: Part) -> str:
    """Return the type of the component of a channel, an axis or a spindle."""
    if part.kind == "channel":
        return "Path"
    return "Linear" if part.kind == "axis" and part.is_linear else "Rotary"
