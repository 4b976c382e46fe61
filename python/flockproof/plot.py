"""Pictures of results, with matplotlib (``pip install "flockproof[plot]"``).

Each function draws into ``axes``, or into a new figure, and returns the axes. Without matplotlib it raises
ImportError, which says how to install it; what is none of this package's results is a TypeError.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import numpy as np

from ._extras import needed
from ._flock import Run, Settlement
from ._platoon import Platoon
from ._queries import Resonance, Spectrum
from ._runs import Simulation

__all__ = ["bode", "network", "observables", "paths", "resonances", "spectrum"]


def _needed(value: object, kinds: type | tuple[type, ...], name: str, maker: str) -> None:
    if not isinstance(value, kinds):
        raise TypeError(f"{name} should be what {maker} gives, but it is `{str(value)[:60]}`")


def _axes(axes: Any) -> Any:
    if axes is not None:
        return axes
    return needed("matplotlib.pyplot", "plot").subplots(layout="constrained")[1]


def paths(simulation: Simulation, axes: Any = None) -> Any:
    """The paths of the agents in the plane, or their one coordinate or phase over time.

    Parameters
    ----------
    simulation
        Of :func:`flockproof.simulate`; lengths and times in the units of its scenario, phases in radians.
    axes
        Of matplotlib; left out, those of a new figure.

    Returns
    -------
    matplotlib.axes.Axes
    """
    _needed(simulation, Simulation, "simulation", "flockproof.simulate")
    axes = _axes(axes)
    positions = simulation.states.get("positions")
    if positions is None:
        axes.plot(simulation.t, np.unwrap(simulation.phases, axis=0), lw=1)
        axes.set(xlabel="t", ylabel="phase (radians)")
    elif positions.shape[2] == 1:
        axes.plot(simulation.t, positions[:, :, 0], lw=1)
        axes.set(xlabel="t", ylabel="x")
    else:
        axes.plot(positions[:, :, 0], positions[:, :, 1], lw=1)
        axes.plot(positions[-1, :, 0], positions[-1, :, 1], "o", color="0.2", ms=3)
        axes.set(xlabel="x", ylabel="y", aspect="equal")
    axes.set_title(f"{simulation.model}, t = 0 to {simulation.t[-1]:g}")
    return axes


def observables(simulation: Simulation, names: Iterable[str] | None = None, axes: Any = None) -> Any:
    """Observables over time; all of them where none is named.

    Parameters
    ----------
    simulation
        Of :func:`flockproof.simulate`.
    names
        Some of ``simulation.observables``.
    axes
        Of matplotlib; left out, those of a new figure.

    Returns
    -------
    matplotlib.axes.Axes

    Raises
    ------
    ValueError
        A name that is not one of them.
    """
    _needed(simulation, Simulation, "simulation", "flockproof.simulate")
    axes = _axes(axes)
    for name in simulation.observables if names is None else names:
        if name not in simulation.observables:
            raise ValueError(f"`{name}` is none of {', '.join(simulation.observables)}")
        values = simulation.observables[name]
        label = name if values.ndim == 1 else [f"{name}_{k + 1}" for k in range(values.shape[1])]
        axes.plot(simulation.t, values, label=label)
    axes.set(xlabel="t")
    axes.legend()
    return axes


def resonances(found: Iterable[Resonance] | Resonance, axes: Any = None) -> Any:
    """Amplitudes of main resonances over the number of followers, with what Theorem 1 says.

    Parameters
    ----------
    found
        Of :func:`flockproof.resonance`, one or several, in any order.
    axes
        Of matplotlib; left out, those of a new figure.

    Returns
    -------
    matplotlib.axes.Axes
    """
    found = list(found) if hasattr(found, "__iter__") else [found]
    for one in found:
        _needed(one, Resonance, "found", "flockproof.resonance")
    axes = _axes(axes)
    ordered = sorted(found, key=lambda r: r.followers)
    followers = [r.followers for r in ordered]
    # Enclosures of 15 digits are thinner than any line.
    axes.loglog(followers, [float(r.amplitude) for r in ordered], "o-", ms=3, label="enclosed")
    axes.loglog(followers, [float(r.theorem1.amplitude) for r in ordered], "--", label="Theorem 1")
    axes.set(xlabel="followers", ylabel="largest amplitude of the last car")
    axes.legend()
    return axes


def bode(platoon: Platoon, cars: Iterable[int] | None = None, frequencies: Any = None, axes: Any = None) -> Any:
    """Bode's diagram of cars of a platoon: magnitude (dB) and phase (degrees), the certified peaks marked.

    Parameters
    ----------
    platoon
        A :class:`flockproof.Platoon`.
    cars
        From 1; left out, the last one.
    frequencies
        Angular frequencies (rad/s), increasing; left out, around the peaks. The curves are in floating point.
    axes
        Two of matplotlib, for magnitude and phase; left out, those of a new figure.

    Returns
    -------
    array of two matplotlib.axes.Axes

    Raises
    ------
    ValueError
        A car that is not there, or a number of axes other than two.
    """
    _needed(platoon, Platoon, "platoon", "flockproof.Platoon")
    if axes is None:
        pyplot = needed("matplotlib.pyplot", "plot")
        axes = pyplot.subplots(2, 1, sharex=True, layout="constrained")[1]
    if len(axes) != 2:
        raise ValueError(f"axes should be two, for magnitude and phase, not {len(axes)}")
    chosen = [platoon.followers] if cars is None else [int(car) for car in cars]
    wrong = [car for car in chosen if not 1 <= car <= platoon.followers]
    if wrong:
        raise ValueError(f"car {wrong[0]} is none of the followers 1 to {platoon.followers}")
    peaks = _peaks(platoon, chosen)
    places = [w for w, _ in peaks.values()]
    if frequencies is None:
        low, high = (min(places) / 20, max(places) * 100) if places else (1e-2, 1e2)
        around = [w * np.linspace(0.95, 1.05, 201) for w in places]
        frequencies = np.unique(np.concatenate([np.geomspace(low, high, 2000), *around]))
    frequencies = np.asarray(frequencies, dtype=float)
    values = _responses(platoon, frequencies)[:, [car - 1 for car in chosen]]
    for k, car in enumerate(chosen):
        (line,) = axes[0].semilogx(frequencies, 20 * np.log10(np.abs(values[:, k])), lw=1.2, label=f"car {car}")
        phase = np.degrees(np.unwrap(np.angle(values[:, k])))
        axes[1].semilogx(frequencies, phase, lw=1.2, color=line.get_color())
        if car in peaks:
            w, amplitude = peaks[car]
            axes[0].plot(w, 20 * np.log10(amplitude), "o", color=line.get_color(), ms=5)
    top = max(axes[0].get_ylim()[1], 0)
    axes[0].set(ylabel="magnitude (dB)", ylim=(max(axes[0].get_ylim()[0], top - 100), top))
    axes[1].set(xlabel="angular frequency (rad/s)", ylabel="phase (degrees)")
    axes[0].set_title(f"{platoon.followers} followers" + (", peaks certified" if peaks else ""))
    axes[0].legend()
    return axes


def _peaks(platoon: Platoon, cars: list[int]) -> dict[int, tuple[float, float]]:
    """Frequency and amplitude of certified peaks; none where there is none, or it is not proved."""
    found: dict[int, tuple[float, float]] = {}
    for car in cars:
        try:
            peak = platoon.peak(car, digits=12)
        except ValueError:
            continue
        if peak.frequency is not None and float(peak.frequency) > 0:
            found[car] = (float(peak.frequency), float(peak.amplitude))
    return found


def _responses(platoon: Platoon, frequencies: Any) -> Any:
    """A row for each frequency, a column for each car."""
    a, b, c, _ = platoon.matrices()
    one = np.eye(len(a))
    return np.array([c @ np.linalg.solve(1j * w * one - a, b @ np.array([1, 1j * w])) for w in frequencies])


def spectrum(found: Spectrum, axes: Any = None) -> Any:
    """Eigenvalues in the complex plane, larger where the multiplicity is.

    Parameters
    ----------
    found
        Of :func:`flockproof.spectrum`.
    axes
        Of matplotlib; left out, those of a new figure.

    Returns
    -------
    matplotlib.axes.Axes
    """
    _needed(found, Spectrum, "found", "flockproof.spectrum")
    axes = _axes(axes)
    values = np.array([complex(part) for part in found])
    sizes = [12 * part.multiplicity for part in found]
    axes.scatter(values.real, values.imag, s=sizes, alpha=0.7)
    axes.set(xlabel="real part", ylabel="imaginary part", title=f"{found.graph}, {found.kind}")
    return axes


def network(found: Run | Settlement, axes: Any = None) -> Any:
    """The network of a flock on a circle, birds from 1.

    Parameters
    ----------
    found
        Of ``Flock.run`` or ``Flock.settle``: the network at its end.
    axes
        Of matplotlib; left out, those of a new figure.

    Returns
    -------
    matplotlib.axes.Axes
    """
    _needed(found, (Run, Settlement), "found", "Flock.run or Flock.settle")
    axes = _axes(axes)
    birds = sorted(bird for flock in found.flocks for bird in flock)
    turn = {bird: 2 * np.pi * k / len(birds) for k, bird in enumerate(birds)}
    place = {bird: (np.cos(angle), np.sin(angle)) for bird, angle in turn.items()}
    for i, j in found.edges:
        axes.plot(*zip(place[i], place[j], strict=True), color="0.6", lw=1)
    for flock in found.flocks:
        axes.plot(*zip(*(place[bird] for bird in flock), strict=True), "o", ms=8)
    for bird, (x, y) in place.items():
        axes.annotate(str(bird), (x, y), textcoords="offset points", xytext=(6, 6))
    axes.set(aspect="equal")
    axes.axis("off")
    return axes
