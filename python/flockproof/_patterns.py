"""Symmetric patterns of steered particles on a circle."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from . import _native
from ._numbers import Enclosure, Number, exact
from ._progress import Progress, callback
from ._shown import Shown, table


@dataclass(frozen=True)
class Pattern(Shown):
    """Particles in clusters of equal size, evenly spaced on one circle.

    Attributes
    ----------
    clusters : int
    verdict : str
        ``stable`` (exponentially, up to rotation and translation), ``unstable``, or ``undecided`` by the linearisation.
    abscissa : Enclosure or None
        Of the largest real part of the eigenvalues but those of the symmetries (1/s); None where there are no others.
    zeros : int
        Eigenvalues 0, of which rotation forces one.
    """

    clusters: int
    verdict: str
    abscissa: Enclosure | None
    zeros: int

    def _repr_html_(self) -> str:
        return _patterns_table([self])


@dataclass(frozen=True)
class Patterns(Shown, Sequence[Pattern]):
    """The patterns of some particles, by their number of clusters.

    Attributes
    ----------
    particles : int
    gains : tuple of Fraction
    omega0, spacing : Fraction
    patterns : tuple of Pattern
    """

    particles: int
    gains: tuple[Fraction, ...]
    omega0: Fraction
    spacing: Fraction
    patterns: tuple[Pattern, ...]

    def __len__(self) -> int:
        return len(self.patterns)

    def __getitem__(self, index: Any) -> Any:
        return self.patterns[index]

    def _repr_html_(self) -> str:
        return _patterns_table(self)


def _patterns_table(some: Iterable[Pattern]) -> str:
    rows = [(str(p.clusters), p.verdict, "" if p.abscissa is None else str(p.abscissa), str(p.zeros)) for p in some]
    return table(("clusters", "verdict", "largest real part (1/s)", "eigenvalues 0"), rows)


def pattern(
    particles: int,
    gains: Sequence[Number],
    omega0: Number = "1/10",
    spacing: Number = "1/10",
    progress: Progress = None,
) -> Patterns:
    """Which symmetric patterns of steered particles are stable under given gains, with all-to-all coupling.

    Parameters
    ----------
    particles
        From 1 to 60.
    gains
        ``K_1, K_2, ..`` of the orientation control, up to the last that is not zero.
    omega0
        Turning rate of a particle without control (rad/s), not 0.
    spacing
        ``K_0``, the gain of the spacing control.
    progress
        Called with (stage, done, total), or True.

    Returns
    -------
    Patterns
        One for each number of clusters that divides the number of particles.

    Raises
    ------
    ValueError, TypeError
        Numbers out of range or of the wrong kind.

    Notes
    -----
    Control (20) with (25) of Sepulchre, Paley and Leonard as Paley and others (2007) print it.

    Examples
    --------
    >>> found = pattern(12, ["1/5", "1/5", "-1/25"])
    >>> [(one.clusters, one.verdict) for one in found]
    [(1, 'unstable'), (2, 'unstable'), (3, 'stable'), (4, 'undecided'), (6, 'unstable'), (12, 'unstable')]
    """
    rows = _native.pattern(particles, list(gains), omega0, spacing, callback(progress))
    found = tuple(
        Pattern(clusters, verdict, None if ends is None else Enclosure._of(ends), zeros)
        for clusters, verdict, zeros, ends, _ in rows
    )
    own = tuple(exact(gain, "gains") for gain in gains)
    return Patterns(int(particles), own, exact(omega0, "omega0"), exact(spacing, "spacing"), found)
