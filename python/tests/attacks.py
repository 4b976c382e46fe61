"""Attacks on the results of the project's own: each is read from its words alone and tried on cases that were not chosen by who stated it."""

from __future__ import annotations

import flockproof


def words(claim: str, *phrases: str) -> None:
    """What is attacked still stands so; where the words have changed, the attack has to be read again."""
    statement = flockproof.ledger()[claim].statement
    for phrase in phrases:
        assert phrase in statement, f"{claim}: {statement}"
