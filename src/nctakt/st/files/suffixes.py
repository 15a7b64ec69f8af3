# SPDX-License-Identifier: MIT
"""The ends of the names of a PLC's files."""

from __future__ import annotations

#: Files with objects in XML, and in plain text.
OBJECT_SUFFIXES = (".tcpou", ".tcdut", ".tcgvl", ".tcio", ".tctto")
TEXT_SUFFIXES = (".st", ".iecst", ".exp")
PROJECT_SUFFIX, SYSTEM_SUFFIX = ".plcproj", ".tsproj"
PROJECT_SUFFIXES = (PROJECT_SUFFIX, SYSTEM_SUFFIX)
#: All suffixes that belong to a PLC.
PLC_SUFFIXES = (*OBJECT_SUFFIXES, *TEXT_SUFFIXES, *PROJECT_SUFFIXES)
#: Suffixes that only Structured Text uses: others may use ``.exp``.
SOURCE_SUFFIXES = (*OBJECT_SUFFIXES, ".st", ".iecst")
#: Suffixes by which a folder's files are known to belong to a PLC.
FOLDER_SUFFIXES = (*SOURCE_SUFFIXES, PROJECT_SUFFIX)
