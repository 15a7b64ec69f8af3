# SPDX-License-Identifier: MIT
"""Random programs: compiled and plain to the byte, and against their own evaluator."""

from __future__ import annotations

import hashlib
import json
import os
import subprocess
import sys
from pathlib import Path

from support import st_statements
from support.random_seeds import seeds_in_parts
from support.st_statements import Program, cycles


@seeds_in_parts(16, 6, 8)
def test_programs_do_what_the_rules_say(seeds: range) -> None:
    """ST-302 … 307, ST-501 … 520, ST-711 … 714: all variables after the last cycle; the fault."""
    for seed in seeds:
        program = Program(seed)
        expected, fault = program.expected()
        plc = program.plc()
        found = cycles(plc)
        assert (seed, found[-1][1]) == (seed, fault)
        assert (seed, len(found) - (fault > 0)) == (seed, len(expected))
        if not fault:
            assert (seed, program.values(plc)) == (seed, expected[-1])


@seeds_in_parts(6, 2, 6)
def test_both_modes_leave_the_same_memory(seeds: range) -> None:
    """ST-002: after each cycle, to the byte, whether compiled or not."""
    environment = dict(os.environ, NCTAKT_PLAIN="1", PYTHONPATH=str(Path(__file__).parent.parent))
    script = [sys.executable, st_statements.__file__, str(seeds.start), str(seeds.stop)]
    done = subprocess.run(script, env=environment, check=True, capture_output=True, text=True)
    plain = json.loads(done.stdout)
    for seed in seeds:
        memories = cycles(Program(seed).plc())
        digests = [[hashlib.sha256(memory).hexdigest(), fault] for memory, fault in memories]
        assert (seed, digests) == (seed, plain[str(seed)])
