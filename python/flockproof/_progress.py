"""What is told while long work runs."""

from __future__ import annotations

import sys
from collections.abc import Callable
from typing import TypeAlias

#: A function of (stage, done, total or None); True prints to standard error.
Progress: TypeAlias = Callable[[str, int, int | None], object] | bool | None


def callback(progress: Progress) -> Callable[[str, int, int | None], object] | None:
    """The function that is called about 20 times a second at most."""
    if progress is None or progress is False:
        return None
    if progress is True:
        return _printed
    if callable(progress):
        return progress
    raise TypeError(f"progress should be True or a function of (stage, done, total), but it is `{str(progress)[:60]}`")


def _printed(stage: str, done: int, total: int | None) -> None:
    end = "\n" if done == total else ""
    named = f"{stage}: " if stage else ""
    print(f"\r{named}{done}{'' if total is None else f' of {total}'} ", end=end, file=sys.stderr, flush=True)
