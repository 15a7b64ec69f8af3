# SPDX-License-Identifier: MIT
"""The extension of VS Code: its commands, its grammar."""

from __future__ import annotations

import json
import re
import shutil
import subprocess
from pathlib import Path

import pytest

pytestmark = pytest.mark.slow

legend = pytest.importorskip("nctakt.editor.display.legend", reason="pygls is not installed")
document = pytest.importorskip("nctakt.editor.document")

FOLDER = Path(__file__).parents[2] / "editors" / "vscode"
MANIFEST = json.loads((FOLDER / "package.json").read_text("utf-8"))


def test_the_extension_has_what_the_server_names() -> None:
    """Commands of lenses, modifiers of colours, the languages; no type of NC programs of others."""
    contributed = MANIFEST["contributes"]
    commands = {item["command"] for item in contributed["commands"]}
    assert {"nctakt.run", "nctakt.debug", "nctakt.live", "nctakt.why"} <= commands
    modifiers = {item["id"] for item in contributed["semanticTokenModifiers"]}
    assert modifiers <= set(legend.MODIFIERS)
    languages = {item["id"]: item.get("extensions", []) for item in contributed["languages"]}
    assert languages[document.STRUCTURED_LANGUAGE][0] == ".st"
    own = {ending.lower() for ending in languages.pop(document.STRUCTURED_LANGUAGE)}
    assert own == set(document.SOURCE_SUFFIXES) - {".tctto"}
    assert languages == {"nctakt": [".nctakt"], document.LIST_LANGUAGE: []}
    source = "".join(path.read_text("utf-8") for path in (FOLDER / "src").glob("*.ts"))
    assert all(f'"{command}"' in source for command in commands)


def test_the_package_has_all_files_that_the_manifest_names() -> None:
    """What ``.vscodeignore`` leaves out is not there once the extension is installed."""
    kept = (FOLDER / ".vscodeignore").read_text("utf-8").split()
    contributed = MANIFEST["contributes"]
    named = [item["configuration"] for item in contributed["languages"]]
    named += [item["path"] for kind in ("grammars", "snippets") for item in contributed[kind]]
    named += ["package.nls.json", "package.nls.de.json", MANIFEST["l10n"] + "/bundle.l10n.de.json"]
    for name in (MANIFEST["main"], *named):
        path = Path(name).as_posix()
        assert f"!{path}" in kept or f"!{path.partition('/')[0]}/**" in kept, name


def test_all_texts_of_the_manifest_are_in_both_languages() -> None:
    """Each text for a reader is a key of both files, which have the same keys and no others.

    VS Code takes ``package.nls.de.json`` where its display language is German.
    """
    text = (FOLDER / "package.json").read_text("utf-8")
    named = set(re.findall(r'"%([\w.]+)%"', text))
    files = ("package.nls.json", "package.nls.de.json")
    english, german = (json.loads((FOLDER / name).read_text("utf-8")) for name in files)
    assert named == english.keys() == german.keys()
    assert all(english[key] != german[key] for key in named)
    for word in ("description", "title", "label", "markdownDescription"):
        written = re.findall(rf'"{word}": "([^%"][^"]*)"', text)
        assert written == ["nctakt"] * len(written), word


def test_all_messages_of_the_extension_are_in_german() -> None:
    """What the source gives to ``l10n.t`` is in the bundle, with the same placeholders."""
    source = "".join(path.read_text("utf-8") for path in (FOLDER / "src").glob("*.ts"))
    asked = re.findall(r"l10n\.t\(\s*(['\"])(.*?)\1\s*[,)]", source)
    bundle = FOLDER / MANIFEST["l10n"] / "bundle.l10n.de.json"
    german = json.loads(bundle.read_text("utf-8"))
    assert {text for _, text in asked} == german.keys()
    assert len(asked) == source.count("l10n.t(")
    for text, translated in german.items():
        assert sorted(re.findall(r"\{\d\}", text)) == sorted(re.findall(r"\{\d\}", translated))
    shown = re.findall(r"(?:Message|Unavailable)\((?!vscode\.l10n|\s*vscode\.l10n)(\w+)", source)
    assert set(shown) <= {"error", "complaint"}


def test_what_the_extension_starts_imports_no_module_of_the_folder() -> None:
    """``python -m nctakt`` in a folder that is only opened would run a ``json.py`` there."""
    source = (FOLDER / "src" / "extension.ts").read_text("utf-8")
    assert 'args: [...rest, "lsp"], options: { env: environment() }' in source
    assert '[...rest, "dap"], { env: environment() }' in source
    assert source.count("spawn(") == source.count("env: environment() };\n  const running") == 1
    assert source.count("createTerminal(") == source.count('env: { PYTHONSAFEPATH: "1" }') == 1


def test_no_address_of_a_registry_is_in_the_lock_file() -> None:
    """The lock file holds versions and checksums only."""
    assert '"resolved"' not in (FOLDER / "package-lock.json").read_text("utf-8")


@pytest.mark.skipif(
    shutil.which("npm") is None or not (FOLDER / "node_modules").is_dir(),
    reason="npm ci has not been run in editors/vscode",
)
def test_the_grammar_colours_the_examples() -> None:
    """The grammar's own test, each line of the examples, objects in XML without their markup."""
    done = subprocess.run(
        ["npm", "test"], cwd=FOLDER, capture_output=True, text=True, check=False, timeout=120
    )
    assert done.returncode == 0, done.stdout + done.stderr
