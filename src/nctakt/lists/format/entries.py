# SPDX-License-Identifier: MIT
"""The bytes of a list in ASCII or XML -> its entries."""

from __future__ import annotations

from nctakt.lists.format.reader import Entry, read_list
from nctakt.lists.format.schema import Schema
from nctakt.lists.format.xml_reader import is_xml, read_xml
from nctakt.messages import Collector


def read_entries(file: str, data: bytes, schema: Schema, collector: Collector) -> tuple[Entry, ...]:
    """Return the entries of a list of the kind ``schema``; ``file`` is its name in spans."""
    if is_xml(data):
        return read_xml(file, data, schema, collector)
    return read_list(file, data, schema.dialect, collector)
