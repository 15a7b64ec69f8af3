# SPDX-License-Identifier: MIT
"""A measure that a user's Python function computes of a run."""

from __future__ import annotations

import importlib.util
import math
from collections.abc import Callable, Iterator
from fractions import Fraction
from functools import cache
from pathlib import Path
from typing import Any

from nctakt.base.dataclass import dataclass
from nctakt.files.access import is_file_or_folder
from nctakt.plc.python.user_modules import imports_beside
from nctakt.studies.measuring.measure_nodes import Number
from nctakt.studies.measuring.outcome import NotMeasuredError, Outcome


@dataclass(frozen=True, slots=True)
class PythonMeasure:
    """A user's function of a run: in a file, or as an object."""

    file: Path
    name: str
    function: Callable[..., Number | None] | None = None

    def value(self, outcome: Outcome) -> Number:
        """Return its result.

        Raises ``NotMeasuredError`` if it raises anything, and if the result is neither a finite
        number nor a text; ``None`` means that there is no value.
        """
        try:
            function = self.function or loaded(self.file, self.name)
            result: Any = function(outcome.queries)
            if result is None:
                raise NotMeasuredError
            if isinstance(result, str):
                return result.encode("utf-8", "replace").decode("utf-8")
            number = float(result)
        except NotMeasuredError:
            raise
        except (Exception, SystemExit) as error:
            raise NotMeasuredError(f"{type(error).__name__}: {error}") from error
        if not math.isfinite(number):
            raise NotMeasuredError(f"the result is {number}")
        return Fraction(repr(number))  # the decimal number that is meant: 0.463 is 463 ms

    def signals(self) -> Iterator[str]:
        """Yield nothing: ``record`` of the plan names the signals it reads."""
        yield from ()

    def problem(self) -> str | None:
        """Return why there is no such function, ``None`` if there is one."""
        if self.function is not None:
            return None
        try:
            function = loaded(self.file, self.name)
        except (Exception, SystemExit) as error:  # noqa: BLE001 - whatever a user's file raises
            return f"{type(error).__name__}: {error}"
        return None if callable(function) else f"{self.name} is not a function"


@cache
def loaded(file: Path, name: str) -> Callable[..., Number | None]:
    """Return a function of a Python file, which may import files next to it.

    Raises whatever the file raises.
    """
    if not is_file_or_folder(file):
        raise FileNotFoundError(f"{file.name} is no file")
    spec = importlib.util.spec_from_file_location(f"nctakt_study_{file.stem}", file)
    if spec is None or spec.loader is None:
        raise ImportError(f"{file.name} is not a Python file")
    module = importlib.util.module_from_spec(spec)
    with imports_beside(file):
        spec.loader.exec_module(module)
    function: Callable[..., Number | None] = getattr(module, name)
    return function
