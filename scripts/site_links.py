# SPDX-License-Identifier: MIT
"""A hook of mkdocs: links that lead out of docs/ show the path in the repository instead."""

import re
from typing import Any

_OUTSIDE = re.compile(r"\[([^\]]+)\]\(\.\./((?:\.\./)*)([^)#]+)(?:#[^)]*)?\)")


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
