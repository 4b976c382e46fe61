"""Worst cases of switched linear systems with bounded inputs."""

from __future__ import annotations

import json
import os
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from pathlib import Path
from typing import Any

import numpy as np

from . import _native
from ._flock import _refused
from ._numbers import Enclosure, Number
from ._progress import Progress, callback
from ._questions import _named
from ._runs import named_files, toml
from ._shown import Shown, table, told

System = Mapping[str, Any] | str | os.PathLike[str]


@dataclass(frozen=True)
class Check(Shown):
    """What is known about one check.

    Attributes
    ----------
    holds, verdict, why : str
        The inequality; ``holds``, ``false`` or ``undecided``; how it was found.
    grades : tuple of str
        ``certified`` where the check is decided.
    worst : Enclosure or None
        The least value of the left side of ``>=``, the greatest of ``<=``; None where there is a bound on one side
        only.
    lo, hi : Fraction or None
        The ends of what is known of it.
    margin : Enclosure or None
        How far the worst case is from the bound, above 0 where the check holds.
    at : Enclosure or None
        When it is attained.
    witness : dict or None
        A motion near it: ``at``, ``start``, ``modes``, ``inputs`` and ``value``, as texts.
    """

    holds: str
    verdict: str
    grades: tuple[str, ...]
    worst: Enclosure | None
    lo: Fraction | None
    hi: Fraction | None
    margin: Enclosure | None
    at: Enclosure | None
    witness: Mapping[str, Any] | None = field(hash=False)
    why: str

    def _repr_html_(self) -> str:
        known = (("worst case", self.worst), ("margin", self.margin), ("attained at t", self.at))
        rows = [(name, str(value)) for name, value in known if value is not None]
        return told(f"{self.holds}: {self.verdict}", [self.why]) + table(("", "enclosed"), rows)


@dataclass(frozen=True)
class Reach(Shown, Sequence[Check]):
    """The checks of a system, in their order.

    Attributes
    ----------
    checks : tuple of Check
    from_floats : bool
        Whether a number of the system was a float, which counts as the exact value of that double.
    text : str
        What the command line prints.
    """

    checks: tuple[Check, ...]
    from_floats: bool
    text: str = field(compare=False, default="")
    _system: str = field(compare=False, repr=False, default="")
    _files: Mapping[str, str] = field(compare=False, repr=False, default_factory=dict)

    def tube(self, check: int = 0, samples: int = 160) -> np.ndarray:
        """What the left side of a check can be, over time, enclosed for all motions.

        Parameters
        ----------
        check
            Its number, from 0; of one with several inequalities that which decides.
        samples
            Stretches of time, of equal length.

        Returns
        -------
        numpy.ndarray
            Rows of the times between which the values lie, the least and the greatest one, rounded outwards; none where
            the order of the modes is not fixed.
        """
        return np.array(self._drawn(check, samples)[2]).reshape(-1, 4)

    def _drawn(self, check: int, samples: int) -> tuple[str, str, list[list[float]], list[list[float]]]:
        """The quantity, the bound, the stretches of :meth:`tube`, and the same of the worst motion that was found."""
        if not 0 <= check < len(self.checks):
            raise ValueError(f"check = {check} is not between 0 and {len(self.checks) - 1}")
        if not 1 <= samples <= 100_000:
            raise ValueError(f"samples = {samples} is not between 1 and 100000")
        return _native.reach_tube(self._system, dict(self._files), 6, check, samples)

    def __len__(self) -> int:
        return len(self.checks)

    def __getitem__(self, index: Any) -> Any:
        return self.checks[index]

    def __repr__(self) -> str:
        return self.text.rstrip("\n")

    def _repr_html_(self) -> str:
        rows = [
            (check.holds, check.verdict, _known(check), "" if check.at is None else str(check.at)) for check in self
        ]
        return table(("check", "verdict", "worst case", "attained at"), rows)


def _known(check: Check) -> str:
    """What is known of the worst case."""
    if check.worst is not None:
        return str(check.worst)
    ends = [sign + str(end) for sign, end in (("at least ", check.lo), ("at most ", check.hi)) if end is not None]
    return ", ".join(ends)


def reach(system: System, digits: int = 10, progress: Progress = None) -> Reach:
    """Enclose the worst cases of a switched linear system with bounded inputs, and decide checks about them.

    Parameters
    ----------
    system
        The path of a file, or the same as a dictionary; ``notes/reach.md`` has its keys. In a dictionary ``mode`` may
        be a mapping from names to state-space objects: anything with arrays ``A`` and ``B``, such as those of
        python-control and SciPy.
    digits
        Digits of worst cases for a fixed order of modes.
    progress
        Called with (stage, done, total), or True.

    Returns
    -------
    Reach
        A sequence of :class:`Check`.

    Raises
    ------
    ValueError, TypeError
        What is no system, with the place at fault.
    OSError
        A file that cannot be read.

    Examples
    --------
    >>> answer = reach({
    ...     "system": {"states": ["x"], "inputs": {"u": [-1, 1]}, "start": {"x": 0}},
    ...     "mode": {"only": {"A": [[-1]], "B": [[1]]}},
    ...     "run": {"until": 2},
    ...     "check": [{"holds": "x <= 9/10"}],
    ... })
    >>> answer[0].verdict, "0.8646647167" in str(answer[0].worst)
    ('holds', True)
    """
    floats: list[bool] = []
    if isinstance(system, Mapping):
        text, name = toml({key: _section(key, value, floats) for key, value in system.items()}), None
    elif isinstance(system, (str, os.PathLike)):
        path = Path(system)
        text = _refused(path, lambda: path.read_text(encoding="utf-8-sig"))
        name = os.fspath(system)
    else:
        raise TypeError(f"system should be a dictionary or a path, but it is `{str(system)[:60]}`")
    with _named(name):
        folder = Path() if name is None else Path(name).parent
        files = named_files(text, folder)
        document, words = _native.reach(text, files, digits, callback(progress))
    checks = tuple(_check(found) for found in json.loads(document)["checks"])
    return Reach(checks, bool(floats), words, text, files)


def _section(key: Any, value: Any, floats: list[bool]) -> Any:
    if key == "mode" and isinstance(value, Mapping):
        return [{"name": name, **_matrices(name, mode, floats)} for name, mode in value.items()]
    return value


def _matrices(name: Any, mode: Any, floats: list[bool]) -> dict[str, Any]:
    """The matrices of a mode: of a mapping, or of an object with attributes."""
    if isinstance(mode, Mapping):
        return {key: _exact(value, floats) for key, value in mode.items()}
    if getattr(mode, "dt", None) not in (None, 0):
        raise ValueError(f"mode {str(name)[:60]}: the system is in discrete time, dt = {mode.dt}")
    try:
        return {"A": _exact(mode.A, floats), "B": _exact(mode.B, floats)}
    except AttributeError:
        raise TypeError(f"mode {str(name)[:60]}: a mapping or an object with A and B is needed") from None


def _exact(value: Any, floats: list[bool]) -> Any:
    """Floats as fractions; the rest as it is."""
    if isinstance(value, np.ndarray):
        value = value.tolist()
    if isinstance(value, (float, np.floating)):
        floats.append(True)
        if not np.isfinite(value):
            raise ValueError(f"`{value}` is not a number")
        return str(Fraction(float(value)))
    if isinstance(value, (list, tuple)):
        return [_exact(x, floats) for x in value]
    return value


def _check(found: Mapping[str, Any]) -> Check:
    def enclosed(ends: Mapping[str, str | None] | None) -> Enclosure | None:
        if ends is None or ends["lo"] is None or ends["hi"] is None:
            return None
        return Enclosure._of((ends["lo"], ends["hi"]))

    def end(number: Number | None) -> Fraction | None:
        return None if number is None else Fraction(str(number))

    worst = found["worst"]
    return Check(
        found["holds"],
        found["verdict"],
        tuple(found["grades"]),
        enclosed(worst),
        end(worst["lo"]),
        end(worst["hi"]),
        enclosed(found["margin"]),
        enclosed(found["at"]),
        found["witness"],
        found["why"],
    )
