# SPDX-License-Identifier: MIT
"""Fair shares of what all clients of a server have together."""

from nctakt.servers.shares import greediest


def test_who_has_most_makes_room_for_who_has_less() -> None:
    assert greediest({"a": 3, "b": 5}, "c") == "b"
    assert greediest({"a": 3, "b": 5}, "a") == "b"
    assert greediest({"a": 3, "b": 5}, "b") is None
    assert greediest({"a": 1, "b": 1}, "c") is None
    assert greediest({}, "c") is None


def test_a_round_of_takers_ends_with_equal_shares() -> None:
    """Each asks as often as it likes; nothing goes round in circles."""
    counts = {"a": 500}
    for _ in range(1000):
        for client in "bcdefghij":
            loser = greediest(counts, client)
            if loser is not None:
                counts[loser] -= 1
                counts[client] = counts.get(client, 0) + 1
    assert sum(counts.values()) == 500
    assert max(counts.values()) - min(counts.values()) <= 1
