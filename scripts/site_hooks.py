# SPDX-License-Identifier: MIT
"""Hooks of mkdocs: each page has the version; links out of docs/ show the path instead."""

import re
import runpy
from pathlib import Path
from typing import Any

VERSION = Path(__file__).parent.parent / "src" / "nctakt" / "base" / "version.py"
_OUTSIDE = re.compile(r"\[([^\]]+)\]\(\.\./((?:\.\./)*)([^)#]+)(?:#[^)]*)?\)")


def on_config(config: Any, **_: Any) -> Any:
    """Return the site's settings with the version below each page."""
    config.copyright = f"nctakt {runpy.run_path(str(VERSION))['__version__']}"
    return config


def on_page_markdown(markdown: str, page: Any, **_: Any) -> str:
    """Return the page's text with the links out of docs/ as text and path."""
    depth = page.file.src_uri.count("/")

    def shown(link: re.Match[str]) -> str:
        text, more, path = link.groups()
        ups = 1 + more.count("../")
        if ups <= depth:
            return link[0]
        return f"`{path}`" if text.strip("`") == path else f"{text} (`{path}`)"

    return _OUTSIDE.sub(shown, markdown)
