# SPDX-License-Identifier: MIT
"""Names of elements for those who do not see the page: screen readers, and tests as they.

In: an element, its name. Out: the same element.
"""

from __future__ import annotations

from typing import TypeVar

from nicegui import ui
from nicegui.element import Element

AnyElement = TypeVar("AnyElement", bound=Element)


def named(element: AnyElement, name: str) -> AnyElement:
    """Give an element its name; returns the element."""
    element.props["aria-label"] = name
    return element


def explained(element: AnyElement, name: str) -> AnyElement:
    """Give an element its name, also as a tooltip; returns the element."""
    return named(element, name).tooltip(name)


def card(name: str, classes: str) -> Element:
    """Return an empty card of the page, a region that a reader can jump to."""
    return named(ui.element("section").classes(f"nc-card {classes}"), name)
