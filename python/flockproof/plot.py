"""Pictures of results, with matplotlib (``pip install "flockproof[plot]"``).

Each function draws into ``axes``, or into a new figure whose colours are told apart by colour-blind readers too, and
returns the axes. Without matplotlib it raises ImportError, which says how to install it; what is none of this package's
results is a TypeError.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from fractions import Fraction
from typing import TYPE_CHECKING, Any

import numpy as np

from ._extras import needed
from ._fit import Fit
from ._flock import Flock, Run, Settlement
from ._numbers import Enclosure
from ._patterns import Patterns
from ._platoon import Platoon
from ._queries import Ergodicity, Resonance, Spectrum
from ._questions import Table
from ._runs import Simulation, Tracks
from ._signatures import readable
from ._systems import Reach

if TYPE_CHECKING:
    from matplotlib.axes import Axes

__all__ = [
    "against",
    "bode",
    "circle",
    "ergodicity",
    "fit",
    "network",
    "observables",
    "paths",
    "patterns",
    "portrait",
    "reach",
    "resonances",
    "settlement",
    "spacetime",
    "spectrum",
    "sweep",
    "tracks",
]


def __dir__() -> list[str]:
    return sorted(__all__)


#: Okabe and Ito's colours.
_COLOURS = ("#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#000000")


def _needed(value: object, kinds: type | tuple[type, ...], name: str, maker: str) -> None:
    if not isinstance(value, kinds):
        raise TypeError(f"{name} should be what {maker} gives, but it is `{str(value)[:60]}`")


def _axes(axes: Axes | None) -> Axes:
    if axes is not None:
        return axes
    axes = needed("matplotlib.pyplot", "plot").subplots(layout="constrained")[1]
    axes.set_prop_cycle(color=_COLOURS)
    return axes


def _legend(axes: Any) -> None:
    """Below the axes, long ones beside them, where their figure makes room for it, so that no curve is hidden."""
    if axes.figure.get_layout_engine() is None:
        axes.legend()
        return
    labels = axes.get_legend_handles_labels()[1]
    if len(labels) > 10:
        axes.legend(loc="upper left", bbox_to_anchor=(1, 1), fontsize="small", frameon=False)
        return
    down = needed("matplotlib.transforms", "plot").ScaledTranslation(0, -0.5, axes.figure.dpi_scale_trans)
    columns = 1 if any(len(label) > 18 for label in labels) else 2
    below = {"loc": "upper center", "bbox_to_anchor": (0.5, 0), "bbox_transform": axes.transAxes + down}
    axes.legend(**below, ncols=columns, fontsize="small", frameon=False)


def _whole(axes: Axes) -> None:
    """Ticks at whole numbers along the axis; axes of somebody else may have ticks of another kind, which stay."""
    locator = axes.xaxis.get_major_locator()
    if isinstance(locator, needed("matplotlib.ticker", "plot").MaxNLocator):
        locator.set_params(integer=True)


def _without_jumps(positions: Any) -> Any:
    """Paths in a periodic box, broken where they leave at one side and come back at the other."""
    jumps = np.abs(np.diff(positions, axis=0)) > np.ptp(positions, axis=(0, 1)) / 2
    broken = positions.astype(float)
    broken[1:][jumps.any(axis=2)] = np.nan
    return broken


def paths(simulation: Simulation, axes: Axes | None = None) -> Axes:
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
        drawn = _without_jumps(positions) if simulation.model == "vicsek-noise" else positions
        axes.plot(drawn[:, :, 0], drawn[:, :, 1], lw=1)
        axes.plot(positions[-1, :, 0], positions[-1, :, 1], "o", color="0.2", ms=3)
        axes.set(xlabel="x", ylabel="y")
        axes.set_aspect("equal", adjustable="datalim")
    axes.set_title(f"{simulation.model}, t = 0 to {simulation.t[-1]:g}")
    return axes


def observables(simulation: Simulation, names: Iterable[str] | None = None, axes: Axes | None = None) -> Axes:
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
    styles = ("-", "--", ":", "-.")
    for name in simulation.observables if names is None else names:
        if name not in simulation.observables:
            raise ValueError(f"`{name}` is none of {', '.join(simulation.observables)}")
        values = simulation.observables[name]
        label = name if values.ndim == 1 else [f"{name}_{k + 1}" for k in range(values.shape[1])]
        # Beyond the colours lines are told apart by their style.
        axes.plot(simulation.t, values, label=label, ls=styles[len(axes.get_lines()) // len(_COLOURS) % len(styles)])
    axes.set(xlabel="t")
    _legend(axes)
    return axes


def resonances(found: Iterable[Resonance] | Resonance, axes: Axes | None = None) -> Axes:
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
    axes.set(xlabel="followers", ylabel="peak of the last car")
    axes.tick_params(which="minor", labelbottom=False, labelleft=False)
    if len(set(followers)) < 7:
        axes.set_xticks(followers, [str(n) for n in followers])
    _legend(axes)
    return axes


def bode(
    platoon: Platoon,
    cars: Iterable[int] | None = None,
    frequencies: Iterable[float] | None = None,
    axes: Sequence[Axes] | None = None,
) -> Sequence[Axes]:
    """Bode's diagram of cars of a platoon: magnitude (dB) and phase (degrees), the certified peaks marked.

    The title says where a platoon is not stable, so that nothing settles into this response.

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
        axes[0].set_prop_cycle(color=_COLOURS)
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
    growth = np.linalg.eigvals(platoon.matrices()[0]).real.max()
    said = f", not stable:\ngrows like exp({growth:.3g} t)" if growth > 1e-9 else ""
    axes[0].set_title(f"{platoon.followers} followers" + (", peaks certified" if peaks else said), fontsize="medium")
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


def spectrum(found: Spectrum, axes: Axes | None = None) -> Axes:
    """Eigenvalues in the complex plane, of several multiplicities with a number above each that is multiple.

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
    axes.scatter(values.real, values.imag, s=14, alpha=0.7)
    for value, part in zip(values, found, strict=True):
        if part.multiplicity > 1:
            axes.annotate(
                str(part.multiplicity),
                (value.real, value.imag),
                textcoords="offset points",
                xytext=(0, 5),
                ha="center",
                fontsize="small",
            )
    axes.set(xlabel="real part", ylabel="imaginary part", title=f"{found.graph}, {found.kind}")
    if not values.imag.any():
        # Real ones lie on a line; a scale above and below it would say nothing.
        axes.set(ylim=(-1, 1), yticks=[0])
    return axes


def ergodicity(found: Ergodicity, axes: Axes | None = None) -> Axes:
    """The coefficients of ergodicity of the products of the first 1, 2, .. matrices, on a logarithmic scale.

    A product whose rows are all equal has coefficients 0, which the scale leaves out.

    Parameters
    ----------
    found
        Of :func:`flockproof.ergodicity`.
    axes
        Of matplotlib; left out, those of a new figure.

    Returns
    -------
    matplotlib.axes.Axes
    """
    _needed(found, Ergodicity, "found", "flockproof.ergodicity")
    axes = _axes(axes)
    factors = [part.t for part in found.prefixes]
    for label, values in (
        ("tau_1", [float(part.tau_1) for part in found.prefixes]),
        ("tau_2", [float(part.tau_2) for part in found.prefixes]),
    ):
        axes.semilogy(factors, [value if value > 0 else np.nan for value in values], "o-", ms=3, label=label)
    _whole(axes)
    axes.set(xlabel="factors", ylabel="coefficient of ergodicity")
    _legend(axes)
    return axes


def fit(found: Fit, axes: Axes | None = None) -> Axes:
    """The fitted parameters with their intervals of 95 %; the title has what the law and its negative control explain.

    Parameters
    ----------
    found
        Of :func:`flockproof.fit`; each parameter in its own unit.
    axes
        Of matplotlib; left out, those of a new figure.

    Returns
    -------
    matplotlib.axes.Axes
    """
    _needed(found, Fit, "found", "flockproof.fit")
    axes = _axes(axes)
    for k, (name, value) in enumerate(found.parameters.items()):
        low, high = found.intervals[name]
        axes.errorbar(value, k, xerr=[[value - low], [high - value]], fmt="o", ms=4, capsize=3)
    axes.set_yticks(range(len(found.parameters)), list(found.parameters))
    axes.set_ylim(len(found.parameters) - 0.4, -0.6)
    beside = f", shuffled at most {100 * max(found.control):.1f} %" if found.control else ""
    axes.set(xlabel="value, with 95 % intervals")
    axes.set_title(f"{100 * found.explained:.1f} % explained{beside}", fontsize="medium")
    return axes


def network(found: Run | Settlement, axes: Axes | None = None) -> Axes:
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
        # Outside of the circle, where no line is.
        axes.annotate(str(bird), (x, y), textcoords="offset points", xytext=(13 * x, 11 * y), ha="center", va="center")
    axes.set(aspect="equal")
    axes.axis("off")
    return axes


def settlement(found: Settlement, axes: Axes | None = None) -> Axes:
    """Which pairs of birds are linked, over time: a bar for each link, until the last switch and a little longer.

    Parameters
    ----------
    found
        Of ``Flock.settle``, with at least one link at some time.
    axes
        Of matplotlib; left out, those of a new figure.

    Returns
    -------
    matplotlib.axes.Axes

    Raises
    ------
    ValueError
        No two birds are ever linked, or a switch comes at a time beyond floating point.
    """
    _needed(found, Settlement, "found", "Flock.settle")
    times = [switch.t for switch in found.switches]
    if any(abs(t) > 2**1000 for t in times):
        raise ValueError("a switch comes at a time that is too large for a picture")
    last = max(times, default=0)
    end = last + max(1, last // 10)
    # Backwards from the last network.
    until: dict[tuple[int, int], int] = dict.fromkeys(found.edges, end)
    bars: list[tuple[tuple[int, int], int, int]] = []
    for switch in reversed(found.switches):
        bars += [(pair, switch.t, until.pop(pair)) for pair in switch.gained if pair in until]
        until.update(dict.fromkeys(switch.lost, switch.t))
    bars += [(pair, 0, to) for pair, to in until.items()]
    if not bars:
        raise ValueError("no two birds are ever linked")
    axes = _axes(axes)
    place = {pair: k for k, pair in enumerate(sorted({pair for pair, _, _ in bars}))}
    for pair, since, to in bars:
        axes.plot(
            [since, to], [place[pair]] * 2, lw=4, solid_capstyle="butt", color=_COLOURS[place[pair] % len(_COLOURS)]
        )
    count = len(found.switches)
    if last > 1000:
        axes.set_xscale("symlog", linthresh=1)
    axes.set_yticks(range(len(place)), [f"{i}-{j}" for i, j in place])
    axes.set_ylim(-0.6, len(place) - 0.4)
    axes.set(xlabel="t", ylabel="linked birds", title=f"{count} switch{'' if count == 1 else 'es'}, {found.ending}")
    return axes


#: Later than this every step would have to be made again for each column of pixels.
_LATEST = 10_000


def spacetime(flock: Flock, until: int | None = None, coordinate: int = 0, axes: Axes | None = None) -> Axes:
    """The space-time diagram of a flock of model D: one coordinate of each bird over time, from exact runs.

    Pairs that become linked are joined at that time by a line, and by a dotted one where they part.

    Parameters
    ----------
    flock
        A :class:`flockproof.Flock`.
    until
        The last time, at most 10000; left out, a little later than the last switch that ``Flock.settle`` finds.
    coordinate
        From 0; in the unit of the flock's positions.
    axes
        Of matplotlib; left out, those of a new figure.

    Returns
    -------
    matplotlib.axes.Axes

    Raises
    ------
    ValueError
        A flock of model K, whose positions are not exact, a coordinate that it has not, or a time that is too late.
    """
    _needed(flock, Flock, "flock", "flockproof.Flock")
    start = flock.run(until=0).positions
    if start is None:
        raise ValueError("a flock of model D is needed; for model K there are paths of a simulation")
    if not 0 <= coordinate < len(start[0]):
        raise ValueError(f"coordinate = {coordinate} is not between 0 and {len(start[0]) - 1}")
    if until is None:
        last = max((switch.t for switch in flock.settle().switches), default=0)
        until = last + max(10, last // 10)
    if not 1 <= until <= _LATEST:
        raise ValueError(f"until = {until} is not between 1 and {_LATEST}")

    def places(t: int) -> list[float]:
        found = flock.run(until=t).positions
        return [] if found is None else [float(row[coordinate]) for row in found]

    axes = _axes(axes)
    times = sorted({round(t) for t in np.linspace(0, until, 401)})
    axes.plot(times, [places(t) for t in times], lw=1.2)
    switches = flock.run(until=until, state=False).switches
    for switch in switches:
        at = places(switch.t)
        for pairs, style in ((switch.gained, "-"), (switch.lost, ":")):
            for i, j in pairs:
                axes.plot([switch.t] * 2, [at[i - 1], at[j - 1]], style, color="0.35", lw=1, marker=".", ms=4)
    name = "xyz"[coordinate] if len(start[0]) <= 3 else f"x_{coordinate + 1}"
    count = len(switches)
    axes.set(xlabel="t", ylabel=name, title=f"{flock.birds} birds, {count} switch{'' if count == 1 else 'es'}")
    return axes


def sweep(table: Table, x: str, y: str, axes: Axes | None = None) -> Axes:
    """A quantity of a sweep over a name or another one.

    Enclosures are drawn by their ends. Where several members have the same ``x``, such as runs with other seeds: each
    as a dot, and the mean with the standard deviation.

    Parameters
    ----------
    table
        Of :func:`flockproof.sweep`.
    x, y
        Columns with numbers. Members without a value are left out.
    axes
        Of matplotlib; left out, those of a new figure.

    Returns
    -------
    matplotlib.axes.Axes

    Raises
    ------
    ValueError
        A column that is not there, or without a number.
    """
    _needed(table, Table, "table", "flockproof.sweep")
    known = [*table.names, *table.columns]
    for name in (x, y):
        if name not in known:
            raise ValueError(f"`{name}` is none of {', '.join(known)}")
    ends = [(_ends(row[x]), _ends(row[y])) for row in table]
    points = sorted((a, b) for a, b in ends if a is not None and b is not None)
    if not points:
        raise ValueError(f"no member has numbers for both {x} and {y}")
    axes = _axes(axes)
    across, up = np.array([a for a, _ in points]), np.array([b for _, b in points])
    place, middle = across.mean(axis=1), up.mean(axis=1)
    if len(set(place)) == len(place):
        errors = np.clip([middle - up[:, 0], up[:, 1] - middle], 0, None)
        axes.errorbar(place, middle, yerr=errors, fmt="o-", ms=3, lw=1)
    else:
        _grouped(axes, place, middle, "members")
    if all(at == round(at) for at in place):
        _whole(axes)
    axes.set(xlabel=x, ylabel=y)
    return axes


def _grouped(axes: Any, place: Any, values: Any, name: str) -> None:
    """Each value as a dot, and of those at one place the mean with the standard deviation."""
    places, which, counts = np.unique(place, return_inverse=True, return_counts=True)
    means = np.bincount(which, values) / counts
    squares = np.bincount(which, (values - means[which]) ** 2)
    deviations = np.sqrt(squares / np.maximum(counts - 1, 1))
    axes.plot(place, values, "o", color="0.6", ms=3, label=name)
    axes.errorbar(places, means, yerr=deviations, fmt="o-", ms=5, lw=1.2, capsize=3, label="mean, standard deviation")
    _legend(axes)


def against(
    runs: Mapping[float, Iterable[Simulation]], observable: str = "order", since: float = 0.0, axes: Any = None
) -> Any:
    """An observable against a parameter, such as the order against the noise: each run, mean and standard deviation.

    Parameters
    ----------
    runs
        For each value of the parameter its runs, of :func:`flockproof.simulate`.
    observable
        One of ``simulation.observables``, averaged over the times of a run; of several numbers the first.
    since
        Earlier times are left out, as the start is not what is asked about.
    axes
        Of matplotlib; left out, those of a new figure.

    Returns
    -------
    matplotlib.axes.Axes

    Raises
    ------
    ValueError
        No run, an observable that is not there, or a run that ends before.
    """
    if not isinstance(runs, Mapping):
        raise TypeError(f"runs should be a mapping from numbers to runs, but it is `{str(runs)[:60]}`")
    place, values = [], []
    for parameter, some in runs.items():
        for one in some:
            _needed(one, Simulation, "runs", "flockproof.simulate")
            if observable not in one.observables:
                raise ValueError(f"`{observable}` is none of {', '.join(one.observables)}")
            late = np.asarray(one.observables[observable])[one.t >= since]
            if not len(late):
                raise ValueError(f"since = {since:g}: a run ends at t = {one.t[-1]:g}")
            place.append(float(parameter))
            values.append(float((late if late.ndim == 1 else late[:, 0]).mean()))
    if not place:
        raise ValueError("there is no run")
    axes = _axes(axes)
    _grouped(axes, np.array(place), np.array(values), "runs")
    axes.set(xlabel="parameter", ylabel=observable)
    return axes


def _ends(value: Any) -> tuple[float, float] | None:
    if isinstance(value, Enclosure):
        return float(value.lo), float(value.hi)
    if isinstance(value, (int, Fraction)) and not isinstance(value, bool):
        return float(value), float(value)
    return None


def portrait(simulation: Simulation, coordinate: int = 0, axes: Axes | None = None) -> Axes:
    """The phase portrait of a run: of each agent its velocity over its position, in one coordinate; a dot at the end.

    Parameters
    ----------
    simulation
        Of :func:`flockproof.simulate`, of a model with velocities; in the units of its scenario.
    coordinate
        From 0.
    axes
        Of matplotlib; left out, those of a new figure.

    Returns
    -------
    matplotlib.axes.Axes

    Raises
    ------
    ValueError
        A model without velocities, or a coordinate that it has not.
    """
    _needed(simulation, Simulation, "simulation", "flockproof.simulate")
    positions, velocities = (simulation.states.get(name) for name in ("positions", "velocities"))
    if positions is None or velocities is None:
        raise ValueError(
            f"the model {simulation.model} has no positions with velocities; it has {', '.join(simulation.states)}"
        )
    if not 0 <= coordinate < positions.shape[2]:
        raise ValueError(f"coordinate = {coordinate} is not between 0 and {positions.shape[2] - 1}")
    axes = _axes(axes)
    axes.plot(positions[:, :, coordinate], velocities[:, :, coordinate], lw=1)
    axes.plot(positions[-1, :, coordinate], velocities[-1, :, coordinate], "o", color="0.2", ms=3)
    name = "xyz"[coordinate] if positions.shape[2] > 1 and coordinate < 3 else "x"
    axes.set(xlabel=name, ylabel=f"velocity of {name}", title=simulation.model)
    return axes


def reach(found: Reach, check: int = 0, axes: Axes | None = None) -> Axes:
    """The quantity of a check over time: enclosed for all motions, and along the worst one that was found.

    It is enclosed where the order of modes is fixed.

    Parameters
    ----------
    found
        Of :func:`flockproof.reach`. The worst case is computed once more.
    check
        Its number, from 0. Of several inequalities the one that decides is drawn.
    axes
        Of matplotlib; left out, those of a new figure.

    Returns
    -------
    matplotlib.axes.Axes

    Raises
    ------
    ValueError
        There is no such check.
    """
    _needed(found, Reach, "found", "flockproof.reach")
    quantity, bound, sections, run = found._drawn(check, 160)
    axes = _axes(axes)
    if sections:
        ends = np.array(sections)
        axes.fill_between(
            ends[:, :2].ravel(),
            np.repeat(ends[:, 2], 2),
            np.repeat(ends[:, 3], 2),
            alpha=0.3,
            label="all motions, enclosed",
        )
    if run:
        points = np.array(run)
        axes.plot(points[:, 0], points[:, 2], lw=1, color="0.2", label="the worst that was found")
    axes.axhline(float(Fraction(bound)), ls="--", lw=1, color=_COLOURS[1], label="the bound asked for")
    axes.set(xlabel="t", ylabel=quantity, title=f"{found[check].holds}: {found[check].verdict}")
    _legend(axes)
    return axes


def circle(simulation: Simulation, row: int = -1, axes: Axes | None = None) -> Axes:
    """Phases on the unit circle at one time, and the order parameter p_1 as an arrow from the centre.

    Parameters
    ----------
    simulation
        Of :func:`flockproof.simulate`, of a model with phases (radians).
    row
        Which of ``simulation.t``; left out, the last.
    axes
        Of matplotlib; left out, those of a new figure.

    Returns
    -------
    matplotlib.axes.Axes

    Raises
    ------
    ValueError
        A model without phases, or a row that is not there.
    """
    _needed(simulation, Simulation, "simulation", "flockproof.simulate")
    phases = simulation.states.get("phases")
    if phases is None:
        raise ValueError(f"the model {simulation.model} has no phases; it has {', '.join(simulation.states)}")
    if not -len(phases) <= row < len(phases):
        raise ValueError(f"row = {row} is none of {len(phases)} times")
    axes = _axes(axes)
    points = np.exp(1j * phases[row])
    turn = np.exp(1j * np.linspace(0, 2 * np.pi, 361))
    axes.plot(turn.real, turn.imag, color="0.7", lw=1)
    axes.plot(points.real, points.imag, "o", ms=6)
    order = points.mean()
    axes.annotate("", xy=(order.real, order.imag), xytext=(0, 0), arrowprops={"arrowstyle": "->", "color": _COLOURS[1]})
    axes.set(aspect="equal", title=f"t = {simulation.t[row]:g}, |p_1| = {abs(order):.3f}")
    axes.axis("off")
    return axes


def tracks(found: Tracks, names: Iterable[str] = ("p_1", "rotation"), axes: Axes | None = None) -> Axes:
    """What was measured in a recording over time; frames that were left out break the lines.

    Parameters
    ----------
    found
        Of :func:`flockproof.tracks`.
    names
        Columns of ``frames.csv``, such as ``p_1`` (polarisation), ``rotation`` (milling, -1 to 1) and
        ``nearest_distance_mean`` (in the unit of the file).
    axes
        Of matplotlib; left out, those of a new figure.

    Returns
    -------
    matplotlib.axes.Axes

    Raises
    ------
    ValueError
        A name that is no column of numbers.
    """
    _needed(found, Tracks, "found", "flockproof.tracks")
    frames = found.table("frames")
    known = [name for name in frames.dtype.names or () if frames.dtype[name].kind in "fi"]
    chosen = list(names)
    for name in chosen:
        if name not in known:
            raise ValueError(f"`{name}` is none of {', '.join(known)}")
    axes = _axes(axes)
    for name in chosen:
        axes.plot(frames["t"], frames[name], lw=1.2, label=found._with_unit(name))
    axes.set(xlabel="time (s)", title=str(found.summary["source"]))
    _legend(axes)
    return axes


def patterns(found: Patterns, axes: Axes | None = None) -> Axes:
    """Symmetric patterns on a circle, three in a row: filled where they are stable, hollow where they are not.

    Parameters
    ----------
    found
        Of :func:`flockproof.pattern`.
    axes
        Of matplotlib; left out, those of a new figure.

    Returns
    -------
    matplotlib.axes.Axes
    """
    _needed(found, Patterns, "found", "flockproof.pattern")
    axes = _axes(axes)
    turn = np.exp(1j * np.linspace(0, 2 * np.pi, 181))
    # Told apart by shape as well as by colour.
    looks: dict[str, dict[str, Any]] = {
        "stable": {"marker": "o", "color": _COLOURS[0]},
        "unstable": {"marker": "o", "mfc": "none", "color": _COLOURS[1]},
        "undecided": {"marker": "x", "color": _COLOURS[6]},
    }
    for k, one in enumerate(found):
        row, column = divmod(k, 3)
        across, up = 3.2 * column, -4.2 * row
        axes.plot(across + turn.real, up + turn.imag, color="0.75", lw=1)
        places = np.exp(2j * np.pi * np.arange(one.clusters) / one.clusters)
        axes.plot(across + places.real, up + places.imag, ls="none", ms=6, **looks[one.verdict])
        words = f"{one.clusters} cluster{'s' if one.clusters > 1 else ''}\n{one.verdict}"
        axes.text(across, up - 1.35, words, ha="center", va="top", fontsize="small")
    # Fractions that stand for floats are too long for a title.
    gains = ", ".join(str(gain) if len(str(gain)) < 9 else f"{float(gain):g}" for gain in found.gains)
    bottom = -4.2 * ((len(found) - 1) // 3) - 3
    axes.set(aspect="equal", xlim=(-1.6, 3.2 * min(len(found), 3) - 1.6), ylim=(bottom, 1.4))
    axes.set_title(f"{found.particles} particles, K = {gains}", fontsize="medium")
    axes.axis("off")
    return axes


readable(globals(), __all__)
