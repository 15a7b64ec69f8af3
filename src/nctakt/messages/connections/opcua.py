# SPDX-License-Identifier: MIT
"""Messages about the server for OPC UA."""

from __future__ import annotations

from nctakt.messages.catalogue import error
from nctakt.messages.extras import install_command

SECURITY_FOLDER_NOT_USABLE = error(
    901472,
    en="the folder {folder} of certificate and users cannot be used: {reason}",
    de="der Ordner {folder} mit Zertifikat und Benutzern ist nicht verwendbar: {reason}",
    remedy_en="Name a folder that can be written to, or repair or delete its files.",
    remedy_de="Einen beschreibbaren Ordner nennen oder seine Dateien berichtigen oder löschen.",
)
OPCUA_LIBRARY_MISSING = error(
    901473,
    en="nctakt serve --opcua needs the library asyncua, which is not installed",
    de="nctakt serve --opcua braucht die Bibliothek asyncua, die nicht installiert ist",
    remedy_en=f"Install it: {install_command('opcua')}",
    remedy_de=f"Installieren: {install_command('opcua')}",
)
