# SPDX-License-Identifier: MIT
"""The process of an isolated FMU: answers the calls of an ``IsolatedInstance``, a line each.

In: standard input. Out: the standard output of the start; output of a model goes to the error
output. It ends with its input.
"""

from __future__ import annotations

import json
import os
import pickle
import signal
import sys
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

from nctakt.fmu.description import FmuDescription, FmuVariable
from nctakt.fmu.failures import FmuError, fmpy
from nctakt.fmu.instance import FmuInstance


class Guest:
    """The calls by their names."""

    def __init__(self, description: FmuDescription, folder: Path) -> None:
        self._variables = description.variables
        self._description = description
        self._folder = folder
        self._instance: FmuInstance | None = None

    def load(self) -> None:
        """Load the model's library."""
        self._instance = FmuInstance(self._description, self._folder)

    @property
    def instance(self) -> FmuInstance:
        """The instance, once it is loaded."""
        assert self._instance is not None
        return self._instance

    def begin(self, start: Mapping[str, Any], inputs: Mapping[str, Any]) -> None:
        """Initialise."""
        self.instance.begin(self._values(start), self._values(inputs))

    def get(self, names: list[str]) -> Mapping[str, Any]:
        """Return values."""
        return self.instance.get([self._variables[name] for name in names])

    def advance(self, inputs: Mapping[str, Any], step_us: int, names: list[str]) -> Any:
        """Make a step."""
        variables = [self._variables[name] for name in names]
        return self.instance.advance(self._values(inputs), step_us, variables)

    def end(self) -> None:
        """End the instance."""
        self.instance.end()

    def _values(self, values: Mapping[str, Any]) -> dict[FmuVariable, Any]:
        return {self._variables[name]: value for name, value in values.items()}


def answer(call: Callable[..., Any], words: list[Any]) -> Mapping[str, Any]:
    """Return the answer to a call."""
    try:
        return {"value": call(*words)}
    except FmuError as failure:
        return {
            "failures": [
                (one.id, {name: str(value) for name, value in one.values.items()})
                for one in failure.diagnostics
            ]
        }


def main() -> None:
    """Answer calls until the input ends."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # the other process ends this one
    with os.fdopen(os.dup(1), "wb") as answers:
        os.dup2(2, 1)
        guest = Guest(*pickle.load(sys.stdin.buffer))
        fmpy()
        calls: dict[str, Callable[..., Any]] = {
            "load": guest.load,
            "begin": guest.begin,
            "get": guest.get,
            "advance": guest.advance,
            "end": guest.end,
        }
        answers.write(b"\n")
        answers.flush()
        for line in sys.stdin.buffer:
            call, *words = json.loads(line)
            answers.write(json.dumps(answer(calls[call], words)).encode() + b"\n")
            answers.flush()


if __name__ == "__main__":
    main()
