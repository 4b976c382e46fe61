"""Resonances, spectra, products of stochastic matrices."""

from __future__ import annotations

import json
import os
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from fractions import Fraction
from math import inf
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt

from . import _native
from ._flock import _footprint, _refused
from ._graphs import TEXTS, given
from ._numbers import (
    Enclosure,
    ExactMatrix,
    Known,
    Number,
    exact,
    exact_matrix,
    floats_among,
    fraction_text,
    read_decimal,
)
from ._progress import Progress, callback
from ._shown import ROWS, Shown, latex, table, told


@dataclass(frozen=True)
class Theorem1:
    """The two formulas of Theorem 1 of Veerman, Stošić and Olvera, for large M: decimals, rounded down, of what they
    say.
    """

    _texts: tuple[str, str]

    @property
    def frequency(self) -> Fraction:
        """Angular frequency (rad/s)."""
        return read_decimal(self._texts[0])

    @property
    def amplitude(self) -> Fraction:
        """Amplitude of the last car for an amplitude 1 of the leader."""
        return read_decimal(self._texts[1])

    def __repr__(self) -> str:
        return f"Theorem1(frequency={self._texts[0]}, amplitude={self._texts[1]})"


@dataclass(frozen=True)
class Resonance:
    """The main resonance of a two-sided platoon.

    Attributes
    ----------
    frequency : Enclosure
        The angular frequency (rad/s) at which the amplitude of the last car is largest.
    amplitude : Enclosure
        That amplitude, for an amplitude 1 of the leader.
    followers, digits : int
    f, g : Fraction
        The question.
    from_floats : tuple of str
        A sentence for each gain that was given as a float.
    """

    frequency: Enclosure
    amplitude: Enclosure
    followers: int
    f: Fraction
    g: Fraction
    digits: int
    from_floats: tuple[str, ...] = ()

    @property
    def theorem1(self) -> Theorem1:
        """What Theorem 1 of the paper says of frequency and amplitude."""
        return Theorem1(_native.theorem_1(self.followers, self.f, self.g, self.digits))

    def __repr__(self) -> str:
        lines = [
            f"Resonance of {self.followers} followers, f = {self.f}, g = {self.g}",
            f"  frequency  {self.frequency}",
            f"  amplitude  {self.amplitude}",
            f"  Theorem 1  {float(self.theorem1.frequency):.6g}, {float(self.theorem1.amplitude):.6g}",
            *(f"  {sentence}" for sentence in self.from_floats),
        ]
        return "\n".join(lines)

    def _repr_html_(self) -> str:
        head = f"{self.followers} followers, f = {self.f}, g = {self.g}"
        theorem = self.theorem1
        rows = [
            ("frequency (rad/s)", str(self.frequency), f"{float(theorem.frequency):.6g}"),
            ("amplitude", str(self.amplitude), f"{float(theorem.amplitude):.6g}"),
        ]
        return told(head, self.from_floats) + table(("main resonance", "enclosed", "Theorem 1"), rows)

    def _repr_latex_(self) -> str:
        return rf"$\omega \in {_inner(self.frequency)},\quad |G(i\omega)| \in {_inner(self.amplitude)}$"


def _inner(value: Enclosure) -> str:
    return value._repr_latex_().strip("$")


def resonance(followers: int, f: Number, g: Number, digits: int = 15) -> Resonance:
    """Enclose the main resonance of the two-sided platoon: the global maximum of the amplitude of the last car.

    Parameters
    ----------
    followers
        Number of cars behind the leader, from 1 to 10^12. The cost grows like its logarithm.
    f, g
        Gains of the positions (1/s^2) and of the velocities (1/s), both below 0.
    digits
        Significant digits, up to 10 000.

    Returns
    -------
    Resonance
        Rigorous enclosures of frequency and amplitude.

    Raises
    ------
    ValueError, TypeError
        Gains that are not negative, numbers out of range or of the wrong kind.

    Notes
    -----
    Veerman, Stošić and Olvera, *Spatial instabilities and size limitations of flocks* (2007), Theorem 1; that the
    maximum is the global one is proved in ``notes/resonance.md``.

    Examples
    --------
    >>> r = resonance(128, -1, -1, digits=6)
    >>> print(r.amplitude)
    [146.730833, 146.730834]
    >>> r.amplitude > 146, 0.02 in r.frequency
    (True, False)
    """
    omega, amplitude = _native.resonance(followers, f, g, digits)
    floats = floats_among(f=f, g=g)
    found = object.__new__(Resonance)
    # A tenth of the time that the constructor of a frozen class takes.
    found.__dict__.update(
        frequency=Enclosure._of(omega, bool(floats)),
        amplitude=Enclosure._of(amplitude, bool(floats)),
        followers=int(followers),
        f=exact(f, "f"),
        g=exact(g, "g"),
        digits=int(digits),
        from_floats=floats,
    )
    return found


@dataclass(frozen=True)
class Peak:
    """The largest response of a stable linear system over all frequencies.

    Attributes
    ----------
    frequency : Enclosure or None
        An angular frequency (rad/s) that has it. Where several are too close in height to be told apart, all of them;
        nothing where it is approached at infinity only.
    amplitude : Enclosure
        Its height, for an amplitude 1 of the input.
    digits : int
    from_floats : tuple of str
        A sentence for each argument that was given in floats.
    """

    frequency: Enclosure | None
    amplitude: Enclosure
    digits: int
    from_floats: tuple[str, ...] = ()

    def __repr__(self) -> str:
        lines = [f"Peak of {self.amplitude} at {self.frequency}", *(f"  {sentence}" for sentence in self.from_floats)]
        return "\n".join(lines)

    def _repr_html_(self) -> str:
        where = "approached at infinity" if self.frequency is None else str(self.frequency)
        rows = [("amplitude", str(self.amplitude)), ("frequency (rad/s)", where)]
        return told("", self.from_floats) + table(("peak", "enclosed"), rows)

    def _repr_latex_(self) -> str:
        at = "" if self.frequency is None else rf"\omega \in {_inner(self.frequency)},\quad "
        return rf"${at}|G(i\omega)| \in {_inner(self.amplitude)}$"


def _peak(found: tuple[tuple[str, str] | None, tuple[str, str]], digits: int, floats: tuple[str, ...]) -> Peak:
    omega, amplitude = found
    frequency = None if omega is None else Enclosure._of(omega, bool(floats))
    return Peak(frequency, Enclosure._of(amplitude, bool(floats)), int(digits), floats)


def peak(
    graph: Any,
    f: Number | Iterable[Number],
    g: Number | Iterable[Number],
    leader: Any = None,
    car: Any = None,
    digits: int = 15,
    *,
    zero_based: bool = False,
) -> Peak:
    """Enclose the largest response of a car of a platoon on any communication graph to a leader that swings.

    Parameters
    ----------
    graph
        Who keeps track of whom, as :func:`spectrum` reads graphs: an arc from i to j says that i tracks j; weights are
        scaled to a sum of one for each vertex. At most 100 followers.
    f, g
        Gains of the positions (1/s^2) and of the velocities (1/s), below 0: one, or one for each follower in order.
    leader, car
        The vertices that lead and that is looked at, as the graph names them; for names, files without names and
        matrices their numbers from 1. Left out: the one called ``leader`` in a file, or the first one, and the last one
        of the others.
    digits
        Significant digits, up to 10 000.
    zero_based
        Whether the vertices of an edge list in a file are numbered from 0.

    Returns
    -------
    Peak
        Rigorous enclosures, with proof that no frequency is worse.

    Raises
    ------
    ValueError, TypeError
        A platoon that is not stable, a car that the leader does not reach, gains that are not negative, what is no
        graph.

    Examples
    --------
    >>> found = peak([("a", "b"), ("b", "c")], -1, -1, leader="a", digits=6)
    >>> print(found.amplitude, found.frequency)
    [2.44321491, 2.44321492] [0.518144615, 0.518144616]
    >>> print(resonance(2, -1, -1, digits=6).amplitude)
    [2.44321491, 2.44321492]
    """
    read = given(graph, bool(zero_based))
    gains = (_listed(f), _listed(g))
    if leader is None and read.native[0] in TEXTS and "leader" in (read.labels or []):
        leader = "leader"
    vertices = (read.root(leader, "leader"), read.root(car, "car"))
    found = _native.peak(read.native, gains, vertices, digits)
    told = floats_among(**{f"{name}[{k}]": x for name, own in zip("fg", gains, strict=True) for k, x in enumerate(own)})
    return _peak(found, digits, (*read.from_floats, *told))


def _listed(gains: Number | Iterable[Number]) -> list[Any]:
    """One gain, or one for each follower."""
    if isinstance(gains, str) or not isinstance(gains, Iterable):
        return [gains]
    return list(gains)


def system_peak(a: Any, b: Any, c: Any, d: Any = None, digits: int = 15) -> Peak:
    """Enclose the largest response of the linear system x' = A x + B u, y = C x + D u over all frequencies.

    Parameters
    ----------
    a, b, c, d
        Matrices as rows of numbers or arrays: A of n x n numbers, n up to 200, B with one column (the input) or two
        (the position of the leader and its velocity), C with one row, D with one row or left out for 0.
    digits
        Significant digits, up to 10 000.

    Returns
    -------
    Peak
        Rigorous enclosures, with proof that no frequency is worse.

    Raises
    ------
    ValueError, TypeError
        A system that is not stable, a response that grows without bound, matrices that do not fit.

    Examples
    --------
    >>> print(system_peak([[0, 1], [-1, "-1/10"]], [[0], [1]], [[1, 0]], digits=6).amplitude)
    [10.0125234, 10.0125235]
    """
    matrices = [exact_matrix(rows, name) for name, rows in zip("ABC", (a, b, c), strict=True)]
    direct = None if d is None else exact_matrix(d, "D")
    floats = tuple(sentence for matrix in [*matrices, *([direct] if direct else [])] for sentence in matrix.from_floats)
    native = [None if m is None else _Matrix(*m.shape, list(m.numerators), m.denominator) for m in (*matrices, direct)]
    return _peak(_native.system_peak((native[0], native[1], native[2], native[3]), digits), digits, floats)


@dataclass(frozen=True)
class Eigenvalue:
    """Part of a spectrum.

    Attributes
    ----------
    value : Enclosure
        The eigenvalue; of one that is not known to be real, the real part.
    multiplicity : int
        How many eigenvalues lie in the enclosure.
    exact : Fraction or None
        The eigenvalue itself where it is known to be this rational.
    imaginary : Enclosure or None
        The imaginary part of one that is not known to be real.
    """

    value: Enclosure
    multiplicity: int
    exact: Fraction | None = None
    imaginary: Enclosure | None = None

    def __float__(self) -> float:
        if self.imaginary is not None:
            raise TypeError("the eigenvalue is not known to be real: complex() has both parts")
        return float(self.value)

    def __complex__(self) -> complex:
        return complex(float(self.value), float(self.imaginary) if self.imaginary is not None else 0.0)

    def __repr__(self) -> str:
        value = str(self.exact) if self.exact is not None else str(self.value)
        imaginary = f" + i {self.imaginary}" if self.imaginary is not None else ""
        return f"Eigenvalue({value}{imaginary}, multiplicity={self.multiplicity})"

    def _repr_latex_(self) -> str:
        times = rf",\quad {self.multiplicity}\ \text{{times}}" if self.multiplicity > 1 else ""
        return f"${_part(self)}{times}$"


def _part(found: Eigenvalue) -> str:
    value = latex(found.exact) if found.exact is not None else _inner(found.value)
    return value if found.imaginary is None else rf"{value} + i\,{_inner(found.imaginary)}"


class Spectrum(list[Eigenvalue]):
    """The eigenvalues by increasing real part, as a list.

    Attributes
    ----------
    graph, kind, method, reason : str
        What the matrix is, how the eigenvalues were found, and on what ground.
    order : int
        The sum of the multiplicities.
    from_floats : tuple of str
    """

    graph: str
    kind: str
    order: int
    method: str
    reason: str
    from_floats: tuple[str, ...]

    def __repr__(self) -> str:
        head = f"Spectrum of {self.graph}, {self.kind}: {self.order} eigenvalues, {self.method}"
        shown = [f"  {part.multiplicity:>6}  {_shown(part)}" for part in self[:20]]
        more = [f"  .. {len(self) - 20} more"] if len(self) > 20 else []
        return "\n".join([head, *shown, *more, *(f"  {sentence}" for sentence in self.from_floats)])

    def _repr_html_(self) -> str:
        head = f"{self.graph}, {self.kind}: {self.order} eigenvalues, {self.method}"
        more = [f"{len(self) - ROWS} more"] if len(self) > ROWS else []
        rows = [(str(part.multiplicity), _shown(part)) for part in self[:ROWS]]
        return told(head, (*self.from_floats, *more)) + table(("multiplicity", "eigenvalue"), rows)

    def _repr_latex_(self) -> str | None:
        if len(self) > ROWS:
            return None

        rows = r" \\ ".join(f"{part.multiplicity} & {_part(part)}" for part in self)
        return rf"$\begin{{array}}{{rl}} \text{{multiplicity}} & \lambda \\ \hline {rows} \end{{array}}$"

    def __array__(self, dtype: npt.DTypeLike | None = None, copy: bool | None = None) -> npt.NDArray[Any]:
        real = all(part.imaginary is None for part in self)
        values: list[Any] = [float(part) if real else complex(part) for part in self for _ in range(part.multiplicity)]
        return np.array(values, dtype=dtype)


def _shown(part: Eigenvalue) -> str:
    value = str(part.exact) if part.exact is not None else str(part.value)
    return value if part.imaginary is None else f"{value} + i {part.imaginary}"


def spectrum(
    graph: Any,
    kind: str = "laplacian",
    digits: int | None = None,
    root: Any = None,
    *,
    zero_based: bool = False,
) -> Spectrum:
    """Enclose the eigenvalues of a matrix of a graph, with multiplicities.

    Parameters
    ----------
    graph
        A name such as ``"ring:12"``, ``"path:30"``, ``"circulant:12:1,3"`` or ``"platoon2:8"``; a file (edge list,
        Matrix Market or GraphML); a graph of networkx (edge attribute ``weight``) or rustworkx; a SciPy sparse matrix,
        a NumPy array or a list of row *lists* with the weight of the arc from i to j in row i, column j; or a list of
        edge *tuples* ``(i, j)`` or ``(i, j, weight)``, undirected, between the vertices that are named in it. Weights
        are exact.
    kind
        ``laplacian``, ``out-degree``, ``in-degree``, ``normalised`` (or ``normalized``), ``walk``, ``reduced`` or
        ``adjacency``.
    digits
        Significant digits; left out: 20 where they are exact, otherwise what floating point with proved bounds gives.
    root
        The vertex that ``reduced`` leaves out, as the graph names it; for names, files and matrices its number from 1.
    zero_based
        Whether the vertices of an edge list in a file are numbered from 0, as networkx writes them.

    Returns
    -------
    Spectrum
        A list of :class:`Eigenvalue`.

    Raises
    ------
    ValueError, TypeError
        What is no graph; directed where undirected is needed; digits that the size does not allow.

    Examples
    --------
    >>> [(str(e.exact), e.multiplicity) for e in spectrum("complete:5")]
    [('0', 1), ('5', 4)]
    >>> print(spectrum([("a", "b"), ("b", "c"), ("c", "d")], digits=6)[1].value)
    [0.585786402, 0.585786462]
    """
    read = given(graph, bool(zero_based))
    if not isinstance(kind, str):
        raise TypeError(f"kind should be a text, but it is `{str(kind)[:60]}`")
    try:
        order, method, reason, parts = _native.spectrum(read.native, kind, read.root(root), digits)
    except ValueError as error:
        told = str(error).replace("there is --zero-based", "there is zero_based=True")
        if isinstance(read.native[0], str) and not told.startswith(("kind", "root", "the number of digits")):
            raise ValueError(f"{read.name}: {told}") from None
        raise
    floats = read.from_floats
    found = Spectrum(
        Eigenvalue(
            Enclosure._of(re, bool(floats)),
            multiplicity,
            None if rational is None else Known(*rational, bool(floats)),
            None if im is None else Enclosure._of(im, bool(floats)),
        )
        for re, im, multiplicity, rational in parts
    )
    found.graph, found.kind, found.order, found.method, found.reason = read.name, kind, order, method, reason
    found.from_floats = floats
    return found


@dataclass(frozen=True)
class Prefix(Shown):
    """A product P(t) ... P(1).

    Attributes
    ----------
    t : int
        How many factors.
    tau_1 : Fraction
        Half the largest 1-norm distance of two rows.
    tau_2 : Enclosure
        The largest Euclidean distance of two rows; ``tau_2_squared`` is a Fraction.
    footprint : array of bool
        Where the product is positive, of its shape.
    """

    t: int
    tau_1: Fraction
    tau_2: Enclosure
    tau_2_squared: Fraction
    footprint: npt.NDArray[np.bool_]

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Prefix):
            return NotImplemented
        mine, theirs = (self.t, self.tau_1, self.tau_2_squared), (other.t, other.tau_1, other.tau_2_squared)
        return mine == theirs and np.array_equal(self.footprint, other.footprint)

    def __hash__(self) -> int:
        return hash((self.t, self.tau_1, self.tau_2_squared, self.footprint.tobytes()))

    def _cells(self) -> tuple[str, str, str, str]:
        above = int(self.footprint.sum())
        return str(self.t), f"{_float(self.tau_1):.10g}", f"{float(self.tau_2):.10g}", str(above)

    def _repr_html_(self) -> str:
        return table(_PREFIX, [self._cells()])


#: The head of a table of products.
_PREFIX = ("factors", "tau_1", "tau_2", "entries above 0")


@dataclass(frozen=True)
class Stabiliser:
    """A stabiliser V_k of the sequence (Chazelle, *Natural algorithms*, proof of Lemma 3.1).

    Attributes
    ----------
    time : int
        T_k, from which on it is seen.
    members : tuple of int
        From 1.
    """

    time: int
    members: tuple[int, ...]


@dataclass(frozen=True)
class Ergodicity:
    """Products of a sequence of row-stochastic matrices.

    Attributes
    ----------
    product : ExactMatrix
        P(t) ... P(1), exact.
    tau_1 : Fraction
        Half the largest 1-norm distance of two rows of the product.
    tau_2 : Enclosure
        The largest Euclidean distance of two rows; its square ``tau_2_squared`` is a Fraction.
    footprints : list of arrays of bool
        Where the products of the first 1, 2, .. factors are positive.
    stabilisers : tuple of Stabiliser
        Empty where the factors are not square.
    prefixes : tuple of Prefix
        All of this for each number of factors.
    from_floats : tuple of str
    changed : tuple of str
        A sentence for each row that ``normalise`` divided by its sum.
    """

    product: ExactMatrix
    prefixes: tuple[Prefix, ...]
    stabilisers: tuple[Stabiliser, ...]
    from_floats: tuple[str, ...] = ()
    changed: tuple[str, ...] = ()

    @property
    def tau_1(self) -> Fraction:
        """Half the largest 1-norm distance of two rows of the product."""
        return self.prefixes[-1].tau_1

    @property
    def tau_2(self) -> Enclosure:
        """The largest Euclidean distance of two rows of the product."""
        return self.prefixes[-1].tau_2

    @property
    def tau_2_squared(self) -> Fraction:
        """The square of ``tau_2``, exact."""
        return self.prefixes[-1].tau_2_squared

    @property
    def footprints(self) -> list[npt.NDArray[np.bool_]]:
        """Where the products of the first 1, 2, .. factors are positive."""
        return [prefix.footprint for prefix in self.prefixes]

    def __repr__(self) -> str:
        rows, columns = self.product.shape
        lines = [
            f"Ergodicity of {len(self.prefixes)} factors, product {rows} x {columns}",
            f"  tau_1  {float(self.tau_1):.10g}",
            f"  tau_2  {float(self.tau_2):.10g}",
            *(f"  V_{k} = {set(s.members)} from T_{k} = {s.time}" for k, s in enumerate(self.stabilisers, 1)),
            *(f"  {sentence}" for sentence in self.from_floats + self.changed[:20]),
            *([f"  and {len(self.changed) - 20} more rows"] if len(self.changed) > 20 else []),
        ]
        return "\n".join(lines)

    def _repr_html_(self) -> str:
        rows, columns = self.product.shape
        head = f"{len(self.prefixes)} factors, product {rows} x {columns}"
        shown = [prefix._cells() for prefix in self.prefixes[:ROWS]]
        more = [f"{len(self.prefixes) - ROWS} more factors"] if len(self.prefixes) > ROWS else []
        seen = [f"V_{k} = {set(s.members)} from T_{k} = {s.time}" for k, s in enumerate(self.stabilisers, 1)]
        return told(head, (*self.from_floats, *self.changed[:20], *more, *seen)) + table(_PREFIX, shown)

    def _repr_latex_(self) -> str | None:
        return self.product._repr_latex_()


def ergodicity(
    matrices: Iterable[Any] | str | os.PathLike[str], progress: Progress = None, *, normalise: bool = False
) -> Ergodicity:
    """Multiply a sequence of row-stochastic matrices exactly; ergodicity coefficients, footprints and stabilisers.

    Parameters
    ----------
    matrices
        P(1), P(2), ..: lists of rows, arrays or :class:`ExactMatrix`, with exact rows that sum to 1; or the path of a
        file in one of the formats of the command line. A row of floats such as ``[0.1, 0.9]`` need not sum to 1
        exactly: use texts or fractions, or ``normalise``.
    progress
        Called with (stage, done, total), or True.
    normalise
        Divide each row by its sum, exactly; ``changed`` tells which rows.

    Returns
    -------
    Ergodicity
        Exact, but for enclosures of square roots.

    Raises
    ------
    ValueError, TypeError
        A matrix that is not row-stochastic, or cannot multiply the one before it.

    Notes
    -----
    Chazelle, *Natural algorithms* (2009), sections 2 and 3: tau_1, tau_2, stabilisers (proof of Lemma 3.1).

    Examples
    --------
    >>> first = [["1/2", "1/2", 0], ["1/2", "1/2", 0], [0, 0, 1]]
    >>> e = ergodicity([first, [[1, 0, 0], [0, "1/3", "2/3"], [0, "1/3", "2/3"]]])
    >>> e.tau_1, e.product[1, 0], len(e.stabilisers)
    (Fraction(2, 3), Fraction(1, 6), 1)
    >>> e = ergodicity([[[0.5, 0.5], [0.1, 0.9]]], normalise=True)
    >>> e.changed
    ('matrix 1, row 2: divided by its sum, 1 +2.776e-17',)
    """
    changed: tuple[str, ...] = ()
    if isinstance(matrices, (str, os.PathLike)):
        read, changed = _sequence_file(Path(matrices), bool(normalise))
        floats: tuple[str, ...] = ()
    else:
        read = _sequence(matrices)
        floats = tuple(sentence for matrix in read for sentence in matrix.from_floats)
        if normalise and read:
            rows = [[[fraction_text(x) for x in row] for row in matrix] for matrix in read]
            read, changed = _read_sequence(json.dumps(rows), True)
    native = [_Matrix(m.shape[0], m.shape[1], list(m.numerators), m.denominator) for m in read]
    told = callback(progress)
    with _advised(normalise):
        product, prefixes, stabilisers = _native.ergodicity(native, told)
    known = bool(floats)
    return Ergodicity(
        ExactMatrix(*product, floats),
        tuple(
            Prefix(t, Known(*tau_1, known), Enclosure._of(tau_2, known), Known(*square, known), _footprint(footprint))
            for t, (tau_1, square, tau_2, footprint) in enumerate(prefixes, 1)
        ),
        tuple(Stabiliser(time, tuple(members)) for time, members in stabilisers),
        floats,
        changed,
    )


@dataclass(frozen=True)
class _Matrix:
    rows: int
    columns: int
    numerators: list[int]
    denominator: int


def _float(x: Fraction) -> float:
    try:
        return float(x)
    except OverflowError:
        return inf


@contextmanager
def _advised(normalise: bool) -> Iterator[None]:
    """What helps against rows that do not sum to 1."""
    try:
        yield
    except ValueError as error:
        advice = "; normalise=True divides each row by its sum" if "sums to" in str(error) and not normalise else ""
        raise ValueError(f"{error}{advice}") from None


def _sequence(matrices: Any) -> list[ExactMatrix]:
    if isinstance(matrices, (ExactMatrix, dict)) or not hasattr(matrices, "__iter__"):
        raise TypeError(f"matrices should be a list of matrices, but it is `{str(matrices)[:60]}`")
    given = list(matrices)
    # One matrix where a sequence of them is expected: the rows of its first row are numbers.
    if given and all(hasattr(row, "__iter__") and not isinstance(row, str) for row in given):
        first = next(iter(given[0]), None) if not isinstance(given[0], (dict, set, frozenset)) else None
        if first is not None and (isinstance(first, str) or not hasattr(first, "__iter__")):
            raise ValueError("matrices should be a list of matrices, and this is one matrix: write [matrix]")
    return [exact_matrix(matrix, f"matrix {k}") for k, matrix in enumerate(given, 1)]


def _read_sequence(text: str, normalise: bool) -> tuple[list[ExactMatrix], tuple[str, ...]]:
    found, changed = _native.read_sequence(text, normalise)
    told = tuple(f"matrix {k}, row {i}: divided by its sum, 1 {_float(Fraction(*s) - 1):+.3e}" for k, i, s in changed)
    return [ExactMatrix(*matrix) for matrix in found], told


def _sequence_file(path: Path, normalise: bool) -> tuple[list[ExactMatrix], tuple[str, ...]]:
    text: str = _refused(path, lambda: path.read_text(encoding="utf-8-sig"))
    try:
        with _advised(normalise):
            return _read_sequence(text, normalise)
    except ValueError as error:
        raise ValueError(f"{path}: {error}") from None
