# SPDX-License-Identifier: MIT
"""Messages about the language server for editors."""

from __future__ import annotations

from nctakt.messages.catalogue import error
from nctakt.messages.extras import install_command

EDITOR_LIBRARY_MISSING = error(
    901290,
    en="nctakt lsp needs the library pygls, which is not installed",
    de="nctakt lsp braucht die Bibliothek pygls, die nicht installiert ist",
    remedy_en=f"Install it: {install_command('editor')}",
    remedy_de=f"Installieren: {install_command('editor')}",
)
NEW_NAME_INVALID = error(
    901980,
    en="{new} cannot be the new name: {form}",
    de="{new} kann nicht der neue Name sein: {form}",
    remedy_en="Give another name.",
    remedy_de="Einen anderen Namen angeben.",
    new=("the new name", "der neue Name"),
    form=("what a name of this kind is", "was ein solcher Name ist"),
)
NEW_NAME_TAKEN = error(
    901981,
    en="{new} is already in use, {where}: the two would become one",
    de="{new} wird schon verwendet, {where}: aus beiden würde eines",
    remedy_en="Give another name, or rename the other one first.",
    remedy_de="Einen anderen Namen angeben oder zuerst den anderen umbenennen.",
    new=("the new name", "der neue Name"),
    where=("where it is used", "wo er verwendet wird"),
)
RENAMED_BY_NUMBER = error(
    901982,
    en="{written} in {where} may mean {name}: its number is computed",
    de="{written} in {where} meint vielleicht {name}: die Nummer wird berechnet",
    remedy_en="Rename it by hand.",
    remedy_de="Von Hand umbenennen.",
    written=("the text with a computed number", "der Text mit einer berechneten Nummer"),
    where=("file and line", "Datei und Zeile"),
    name=("the name that was to be changed", "der Name, der geändert werden sollte"),
)
NAME_IS_FIXED = error(
    901983,
    en="{name} cannot be renamed here: {reason}",
    de="{name} kann hier nicht umbenannt werden: {reason}",
    remedy_en="Rename it where it is given.",
    remedy_de="Dort umbenennen, wo der Name vergeben wird.",
)
