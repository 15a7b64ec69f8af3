# SPDX-License-Identifier: MIT
"""A picture of schedules as a file.

In: ``Figure``, a file name. Out: SVG (no library needed), PNG (matplotlib) or HTML, the picture
with its tables.
"""

from __future__ import annotations

import importlib.util
from html import escape
from pathlib import Path

from nctakt.base.diagnostics import Language
from nctakt.base.failure import Failure
from nctakt.messages import diagnostic
from nctakt.messages.extras import install_command
from nctakt.messages.scheduling.schedule_results import LIBRARY_MISSING, UNKNOWN_PICTURE_FORMAT
from nctakt.schedule.pictures.figure import Figure, svg

_HTML = """\
<!doctype html>
<html lang="{language}">
<head><meta charset="utf-8"><title>{title}</title>
<style>body {{ font-family: sans-serif; margin: 1em; }} div {{ overflow-x: auto; }}</style></head>
<body>
<div>
{picture}</div>
<pre>{report}</pre>
</body>
</html>
"""


def check_picture(path: str) -> None:
    """Raise ``Failure`` (900635, 900634) where such a picture cannot be drawn."""
    ending = Path(path).suffix.lower()
    if ending not in (".svg", ".png", ".html"):
        raise Failure(diagnostic(UNKNOWN_PICTURE_FORMAT, file=path))
    if ending == ".png" and importlib.util.find_spec("matplotlib") is None:
        raise Failure(
            diagnostic(
                LIBRARY_MISSING,
                library="matplotlib",
                what="--plot FILE.png",
                install=install_command("plot"),
            )
        )


def write_picture(figure: Figure, path: Path, language: Language, report: str) -> None:
    """Write a picture; ``report`` is below it in HTML. Raises ``OSError``."""
    ending = path.suffix.lower()
    if ending == ".png":
        from nctakt.schedule.pictures.png import write_png  # noqa: PLC0415 - matplotlib only when needed

        write_png(figure, path)
    elif ending == ".html":
        page = _HTML.format(
            language=language,
            title="nctakt schedule",
            picture=svg(figure),
            report=escape(report),
        )
        path.write_text(page, "utf-8")
    else:
        path.write_text(svg(figure), "utf-8")
