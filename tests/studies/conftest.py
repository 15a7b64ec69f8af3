# SPDX-License-Identifier: MIT
"""A Dask cluster whose worker has none of the user's files and modules."""

from __future__ import annotations

import contextlib
import json
import subprocess
import sys
import time
from collections.abc import Iterator

import pytest


@pytest.fixture
def scheduler(tmp_path_factory: pytest.TempPathFactory) -> Iterator[tuple[str, int]]:
    """The address and the process of a Dask scheduler with one worker, in another folder."""
    distributed = pytest.importorskip("distributed")
    folder = tmp_path_factory.mktemp("cluster")
    file = folder / "scheduler.json"
    dask = [sys.executable, "-m", "dask"]
    with contextlib.ExitStack() as stack:
        started = []
        for words in (
            ["scheduler", "--host", "127.0.0.1", "--port", "0", "--scheduler-file", str(file)],
            ["worker", "--scheduler-file", str(file), "--nthreads", "1"],
        ):
            process = subprocess.Popen(
                [*dask, *words, "--no-dashboard"], cwd=folder, stderr=subprocess.DEVNULL
            )
            stack.callback(process.wait)
            stack.callback(process.kill)
            started.append(process)
            deadline = time.monotonic() + 60
            while not file.exists():
                assert time.monotonic() < deadline
                time.sleep(0.05)
        address = json.loads(file.read_text())["address"]
        with distributed.Client(address, timeout=60) as client:
            client.wait_for_workers(1, timeout=120)
        yield address, started[0].pid
