"""Attacks on results of the project's own: read from their words alone, on cases that nobody chose who stated them."""

from __future__ import annotations

import flockproof


def words(claim: str, *phrases: str) -> None:
    """What is attacked still stands so; where the words have changed, the attack has to be read again."""
    statement = flockproof.ledger()[claim].statement
    for phrase in phrases:
        assert phrase in statement, f"{claim}: {statement}"
