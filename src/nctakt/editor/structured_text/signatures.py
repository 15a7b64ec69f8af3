# SPDX-License-Identifier: MIT
"""The parameters of the open call, shown by an editor while arguments are written."""

from __future__ import annotations

from lsprotocol.types import (
    ParameterInformation,
    Position,
    SignatureHelp,
    SignatureInformation,
)

from nctakt.editor.document import Document
from nctakt.editor.structured_text.completion import called_unit
from nctakt.editor.structured_text.descriptions import comment_of, parameter_text, signature_of
from nctakt.editor.structured_text.positions import position_at
from nctakt.editor.structured_text.project_names import ProjectNames
from nctakt.editor.structured_text.surroundings import surroundings


def signature_help(
    names: ProjectNames, document: Document, position: Position
) -> SignatureHelp | None:
    """Return the signature of the innermost open call, with the argument at the position."""
    file = names.project.file_named(document.name)
    spot = None if file is None else position_at(document, position, file)
    if spot is None:
        return None
    piece, offset = spot
    around = surroundings(piece.text, offset, piece.title, is_declaration=piece.is_declaration)
    if not around.callee:
        return None
    called = called_unit(names, around.callee, names.scope_of(around.unit))
    if called is None:
        return None
    sources = names.project.sources
    parameters = [
        ParameterInformation(parameter_text(one), comment_of(sources, one.start) or None)
        for one in called.parameters
    ]
    active = around.argument
    for index, one in enumerate(called.parameters):
        if around.named and one.name.lower() == around.named.lower():
            active = index
    text = comment_of(sources, called.start) or None
    signature = SignatureInformation(
        signature_of(called, called.path), text, parameters, min(active, len(parameters))
    )
    return SignatureHelp([signature], 0, min(active, len(parameters)))
