# SPDX-License-Identifier: MIT
"""Random chains: forward against a product of 4×4 matrices, and back again (language: 1.4).

``NCTAKT_SEEDS=100000`` makes as many poses of each kind.
"""

from __future__ import annotations

import random

import numpy as np
from support.kinematic_chains import (
    Chain,
    Map,
    classic_direction,
    pointed_chain,
    pose,
    random_chain,
    with_angles,
    with_vector,
)
from support.random_seeds import all_seeds

from nctakt.kernel.kinematics import map_rows
from nctakt.lists.machine.transformations.kinematics import CLASSIC_MODES

TOLERANCE_MM = 1e-9


def random_positions(numbers: random.Random) -> list[float]:
    """Positions of the axes of a pose."""
    linear = [numbers.uniform(-500.0, 500.0) for _ in range(3)]
    angles = [numbers.choice([0.0, 90.0, numbers.uniform(-400.0, 400.0)]) for _ in range(3)]
    return linear + angles


def test_rtcp_there_and_back() -> None:
    """The tip is the product of the joints' motions, and the way back gives the axes (RTCP)."""
    for seed in all_seeds(300, 40):
        numbers = random.Random(seed)
        chain = random_chain(numbers, numbers.randrange(4))
        length = numbers.uniform(0.0, 200.0)
        mapped = Map(chain, length)
        positions = random_positions(numbers)
        tip, direction = pose(chain, length, positions)
        forward = mapped.forward(positions)
        assert np.allclose(forward[:3], tip, rtol=0.0, atol=TOLERANCE_MM), seed
        assert np.allclose(mapped.direction(positions), direction, rtol=0.0, atol=1e-12), seed
        assert forward[3:] == positions[3:]
        spread = linear_spread(chain, positions)
        if spread < 0.2:
            answer = mapped.answer(forward, positions)
            assert (answer == map_rows.SINGULAR) == (spread < 1e-9), seed
            continue
        back = mapped.inverse(forward, positions)
        assert np.allclose(back, positions, rtol=0.0, atol=TOLERANCE_MM), seed


def linear_spread(chain: Chain, positions: list[float]) -> float:
    """Volume of the directions in which the linear axes move the tip."""
    tip = pose(chain, 0.0, positions)[0]
    moved = []
    for i in range(3):
        beside = list(positions)
        beside[i] += 100.0
        moved.append((pose(chain, 0.0, beside)[0] - tip) / 100.0)
    return abs(float(np.linalg.det(np.array(moved))))


def test_complete_there_and_back() -> None:
    """Programmed angles name the tool's direction; the way back reaches tip and direction."""
    for seed in all_seeds(300, 40):
        numbers = random.Random(seed)
        letters = numbers.choice(list(CLASSIC_MODES.values()))
        chain = with_angles(pointed_chain(numbers), letters)
        mapped = Map(chain)
        positions = random_positions(numbers)
        tip, direction = pose(chain, 0.0, positions)
        near = [numbers.uniform(-400.0, 400.0) for _ in range(6)]
        forward = mapped.forward(positions, near)
        named = classic_direction(letters, forward[3], forward[4])
        assert np.allclose(forward[:3], tip, rtol=0.0, atol=TOLERANCE_MM), seed
        assert np.allclose(named, direction, rtol=0.0, atol=1e-12), seed
        assert max(abs(forward[3] - near[3]), abs(forward[4] - near[4])) <= 360.0
        check_back(chain, mapped, forward, near, seed, letters)


def test_two_steps_there_and_back() -> None:
    """A second step leads on from the results of the first one, and back before it."""
    for seed in all_seeds(100, 15):
        numbers = random.Random(seed)
        chains = [random_chain(numbers, 2) for _ in range(2)]
        mapped = Map(chains[0], 50.0, second=chains[1])
        positions = random_positions(numbers)
        between = Map(chains[0], 50.0).forward(positions)
        forward = mapped.forward(positions)
        assert forward == Map(chains[1]).forward(between), seed
        if min(linear_spread(chain, positions) for chain in chains) > 0.2:
            back = mapped.inverse(forward, positions)
            assert np.allclose(back, positions, rtol=0.0, atol=10.0 * TOLERANCE_MM), seed


def test_vector_there_and_back() -> None:
    """A vector of any length names the tool's direction; the way back reaches it."""
    for seed in all_seeds(300, 40):
        numbers = random.Random(seed)
        chain = with_vector(pointed_chain(numbers))
        mapped = Map(chain)
        positions = random_positions(numbers)
        tip, direction = pose(chain, 0.0, positions)
        forward = mapped.forward(positions)
        assert np.allclose(forward[:3], tip, rtol=0.0, atol=TOLERANCE_MM), seed
        assert np.allclose(forward[3:], direction, rtol=0.0, atol=1e-12), seed
        size = numbers.uniform(0.001, 1000.0)
        forward[3:] = [size * part for part in forward[3:]]
        check_back(chain, mapped, forward, positions, seed)


def check_back(
    chain: Chain, mapped: Map, forward: list[float], near: list[float], seed: int, letters: str = ""
) -> None:
    """The way back leads to axes with this tip and this direction, near ``near``."""
    if mapped.answer(forward, near) == map_rows.SINGULAR:
        return
    back = mapped.inverse(forward, near)
    tip, direction = pose(chain, 0.0, back)
    if linear_spread(chain, back) > 0.2:
        assert np.allclose(tip, forward[:3], rtol=0.0, atol=TOLERANCE_MM), seed
    assert abs(back[3] - near[3]) <= 360.0 and abs(back[4] - near[4]) <= 360.0, seed
    wanted = np.array(forward[3:]) / np.linalg.norm(forward[3:])
    if not chain.has_vector:
        wanted = classic_direction(letters, forward[3], forward[4])
    assert np.allclose(direction, wanted, rtol=0.0, atol=1e-10), seed
