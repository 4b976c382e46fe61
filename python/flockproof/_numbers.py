"""Exact numbers in, exact or enclosed numbers out."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from contextvars import ContextVar
from decimal import Decimal
from fractions import Fraction
from math import lcm
from typing import Any, Protocol, SupportsIndex, TypeAlias, cast, overload

import numpy as np
import numpy.typing as npt

from . import _native
from ._shown import latex


class Ratio(Protocol):
    """What calls itself rational: numbers of NumPy, SymPy and gmpy2, for instance."""

    @property
    def numerator(self) -> Any:
        """An integer."""

    @property
    def denominator(self) -> Any:
        """An integer that is not 0."""


#: What is accepted as a number: exact ones, and floats, which stand for the exact value of the double.
Number: TypeAlias = int | Fraction | Decimal | str | float | np.integer[Any] | np.floating[Any] | Ratio


class Known(Fraction):
    """A fraction that this package computed: :mod:`flockproof.claims` trusts it, unless a float went into the question.

    Arithmetic with it gives ordinary fractions.
    """

    __slots__ = ("has_float",)
    has_float: bool

    def __new__(cls, numerator: int, denominator: int = 1, has_float: bool = False) -> Known:
        self = super().__new__(cls, numerator, denominator)
        self.has_float = has_float
        return self

    def __repr__(self) -> str:
        return f"Fraction({self.numerator}, {self.denominator})"

    def __reduce__(self) -> tuple[Any, ...]:
        return (Known, (self.numerator, self.denominator, self.has_float))

    def __copy__(self) -> Known:
        return self

    def __deepcopy__(self, memo: Any) -> Known:
        return self


#: Integers of fewer bits need no look at their length.
SHORT = 1000

#: Where a check of :mod:`flockproof.claims` runs: why what it says is at most simulated.
floats_seen: ContextVar[list[str] | None] = ContextVar("floats_seen", default=None)


def float_seen(reason: str) -> None:
    """Tells a check that is running, if there is one, that a float has a part in what follows."""
    seen = floats_seen.get()
    if seen is not None and reason not in seen:
        seen.append(reason)


def exact(value: Number, name: str = "value") -> Fraction:
    """The exact value of a number.

    Parameters
    ----------
    value
        int, Fraction, Decimal, str (``"-1/2"``, ``"-0.5"``, ``"2.5e-3"``) or a NumPy number. A float is taken as the
        exact value of that double.
    name
        What the message of an error calls it.

    Raises
    ------
    ValueError
        A text that is no number, NaN, infinity, more than 10 000 digits.
    TypeError
        Anything else.

    Examples
    --------
    >>> exact("-0.1"), exact(0.1) == exact("0.1")
    (Fraction(-1, 10), False)
    """
    # Those that are looked at most often, and no classes of somebody's that are derived from them.
    if type(value) is Fraction or type(value) is Known:
        return value
    if type(value) is int and value.bit_length() < SHORT:
        return Fraction(value)
    if is_float(value):
        float_seen(f"{value!r} is a float")
    return Fraction(*_native.ratio(name, value))


def is_float(value: object) -> bool:
    """Whether a number is a float, Python's or NumPy's, or was computed from one here."""
    if isinstance(value, (float, np.floating)):
        return True
    return bool(getattr(value, "has_float", False) or getattr(value, "from_floats", ()))


def floats_among(**values: object) -> tuple[str, ...]:
    """A sentence for each argument that is a float."""
    if all(type(value) is int or type(value) is str for value in values.values()):
        return ()
    sentences = tuple(
        f"{name} = {value!r} is a float and stands for its exact value {exact(cast(Number, value))}"
        for name, value in values.items()
        if is_float(value) and not isinstance(value, (Fraction, Enclosure))
    ) + tuple(
        f"{name} was computed from a float"
        for name, value in values.items()
        if isinstance(value, (Fraction, Enclosure)) and is_float(value)
    )
    for sentence in sentences:
        float_seen(sentence)
    return sentences


def holds_floats(values: object, depth: int = 0) -> bool:
    """Whether there is a float in nested lists or an array; lists in lists in lists are read no further."""
    if isinstance(values, np.ndarray):
        if values.dtype.kind in "fc":
            return True
        return values.dtype.kind == "O" and any(is_float(x) for x in values.ravel().tolist())
    if isinstance(values, (list, tuple)):
        return depth < 3 and any(holds_floats(x, depth + 1) for x in values)
    return is_float(values)


def why_not_exact(value: object) -> str | None:
    """Why a number does not count as exact in a claim; nothing where it does.

    A Fraction or Decimal does not say where it comes from; integers and texts are taken as written, and what this
    package computed is known.
    """
    if isinstance(value, (int, np.integer, str)):
        return None
    if isinstance(value, Enclosure):
        return "an enclosure of floats" if value._from_floats else value._doubt
    if isinstance(value, Known):
        return "it was computed from a float" if value.has_float else None
    if is_float(value):
        return f"{value!r} is a float"
    return f"a {type(value).__name__} does not say where it comes from"


def number_text(value: Number, name: str) -> str:
    """A number as the files of the command line have it; texts are left for it to read."""
    return value if isinstance(value, str) else fraction_text(exact(value, name))


class Undecided(ValueError):
    """The enclosure is too wide to answer."""


class Enclosure:
    """A real number that is known to lie between two rationals.

    Parameters
    ----------
    lo, hi
        The ends, exact; ``hi`` may be left out where it equals ``lo``.

    Notes
    -----
    ``float(x)`` is the double nearest to the middle. ``y in x`` asks whether the number ``y`` lies in it.
    ``+ - * /``, powers and ``abs`` enclose exactly. A comparison, and ``bool(x)``, is answered where it is certain, and
    raises :class:`Undecided` where it is not. ``==`` compares the ends with those of another enclosure.

    Examples
    --------
    >>> x = Enclosure("1.41", "1.42")
    >>> x.mid, x.radius, float(x), "1.4142" in x, x * x < 3
    (Fraction(283, 200), Fraction(1, 200), 1.415, True, True)
    """

    __slots__ = ("_doubt", "_from_floats", "_hi", "_lo", "_text")
    _lo: Fraction | None
    _hi: Fraction | None
    _text: tuple[str, str] | None
    _from_floats: bool
    #: Why it does not count as certified in a claim.
    _doubt: str | None

    def __init__(self, lo: Number, hi: Number | None = None) -> None:
        self._lo = exact(lo, "lo")
        self._hi = self._lo if hi is None else exact(hi, "hi")
        self._text = None
        self._from_floats = is_float(lo) or is_float(hi)
        self._doubt = why_not_exact(lo) or (None if hi is None else why_not_exact(hi))
        if self._lo > self._hi:
            raise ValueError(f"the lower end {self._lo} lies above the upper end {self._hi}")

    @classmethod
    def _of(cls, ends: tuple[str, str], from_floats: bool = False) -> Enclosure:
        """With decimals as the command line prints them; read when they are asked for."""
        self = cls.__new__(cls)
        self._lo = self._hi = None
        self._text = ends
        self._from_floats = from_floats
        self._doubt = None
        return self

    @property
    def lo(self) -> Fraction:
        """The lower end."""
        if self._lo is None:
            assert self._text is not None
            self._lo = read_decimal(self._text[0])
        return self._lo

    @property
    def hi(self) -> Fraction:
        """The upper end."""
        if self._hi is None:
            assert self._text is not None
            self._hi = read_decimal(self._text[1])
        return self._hi

    @property
    def mid(self) -> Fraction:
        """The middle."""
        return (self.lo + self.hi) / 2

    @property
    def radius(self) -> Fraction:
        """Half the width: no number in it is farther from the middle."""
        return (self.hi - self.lo) / 2

    @property
    def from_floats(self) -> tuple[str, ...]:
        """Not empty where a float went into the question."""
        return ("a float went into it",) if self._from_floats else ()

    def __float__(self) -> float:
        return float(self.mid)

    def __contains__(self, value: Number) -> bool:
        return self.lo <= exact(value) <= self.hi

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Enclosure):
            return NotImplemented
        return self.lo == other.lo and self.hi == other.hi

    def __hash__(self) -> int:
        return hash((self.lo, self.hi))

    def _ends(self, other: Any) -> tuple[Fraction, Fraction, bool] | None:
        if isinstance(other, Enclosure):
            return other.lo, other.hi, other._from_floats
        try:
            value = exact(other)
        except TypeError:
            return None
        return value, value, is_float(other)

    def _joined(self, other: Any, ends: Callable[[Fraction, Fraction], list[Fraction]]) -> Enclosure:
        known = self._ends(other)
        if known is None:
            return cast("Enclosure", NotImplemented)
        lo, hi, floats = known
        all_ends = ends(lo, hi)
        result = Enclosure(min(all_ends), max(all_ends))
        result._from_floats = self._from_floats or floats
        result._doubt = self._doubt or why_not_exact(other)
        return result

    def __neg__(self) -> Enclosure:
        return 0 - self

    def __add__(self, other: Number | Enclosure) -> Enclosure:
        return self._joined(other, lambda lo, hi: [self.lo + lo, self.hi + hi])

    __radd__ = __add__

    def __sub__(self, other: Number | Enclosure) -> Enclosure:
        return self._joined(other, lambda lo, hi: [self.lo - hi, self.hi - lo])

    def __rsub__(self, other: Number | Enclosure) -> Enclosure:
        return self._joined(other, lambda lo, hi: [lo - self.hi, hi - self.lo])

    def __mul__(self, other: Number | Enclosure) -> Enclosure:
        return self._joined(other, lambda lo, hi: [x * y for x in (self.lo, self.hi) for y in (lo, hi)])

    __rmul__ = __mul__

    def __truediv__(self, other: Number | Enclosure) -> Enclosure:
        return self._joined(other, lambda lo, hi: _quotients((self.lo, self.hi), (lo, hi)))

    def __rtruediv__(self, other: Number | Enclosure) -> Enclosure:
        return self._joined(other, lambda lo, hi: _quotients((lo, hi), (self.lo, self.hi)))

    def __pos__(self) -> Enclosure:
        return self

    def __abs__(self) -> Enclosure:
        return self._joined(0, lambda lo, hi: size_ends(self.lo, self.hi))

    def __pow__(self, exponent: int) -> Enclosure:
        if not isinstance(exponent, (int, np.integer)):
            return NotImplemented
        if exponent < 0:
            return 1 / self ** (-exponent)
        return self._joined(0, lambda lo, hi: power_ends(self.lo, self.hi, exponent))

    def __bool__(self) -> bool:
        if self.lo == self.hi == 0:
            return False
        if self.lo <= 0 <= self.hi:
            raise Undecided(f"{self} is too wide to tell whether it is zero: ask for more digits")
        return True

    def _compared(self, other: Any, certain: Callable[[Fraction, Fraction], bool | None]) -> bool:
        known = self._ends(other)
        if known is None:
            return cast(bool, NotImplemented)
        answer = certain(known[0], known[1])
        if answer is None:
            raise Undecided(f"{self} is too wide to compare with {other}: ask for more digits")
        return answer

    def __lt__(self, other: Number | Enclosure) -> bool:
        return self._compared(other, lambda lo, hi: True if self.hi < lo else False if self.lo >= hi else None)

    def __le__(self, other: Number | Enclosure) -> bool:
        return self._compared(other, lambda lo, hi: True if self.hi <= lo else False if self.lo > hi else None)

    def __gt__(self, other: Number | Enclosure) -> bool:
        return self._compared(other, lambda lo, hi: True if self.lo > hi else False if self.hi <= lo else None)

    def __ge__(self, other: Number | Enclosure) -> bool:
        return self._compared(other, lambda lo, hi: True if self.lo >= hi else False if self.hi < lo else None)

    def _texts(self) -> tuple[str, str]:
        return self._text or (_text(self.lo), _text(self.hi))

    def __str__(self) -> str:
        lo, hi = self._texts()
        return lo if lo == hi else f"[{lo}, {hi}]"

    def __repr__(self) -> str:
        lo, hi = self._texts()
        return f"Enclosure({lo!r}, {hi!r})"

    def __format__(self, spec: str) -> str:
        return format(float(self), spec) if spec else str(self)

    def _repr_html_(self) -> str:
        lo, hi = self._texts()
        same = 0
        while same < min(len(lo), len(hi)) and lo[same] == hi[same]:
            same += 1
        return f"<span title='[{lo}, {hi}]'><b>{lo[:same]}</b><sub>{lo[same:]}</sub><sup>{hi[same:]}</sup></span>"

    def _repr_latex_(self) -> str:
        lo, hi = map(latex, self._texts())
        return f"${lo}$" if lo == hi else rf"$[{lo},\ {hi}]$"

    def __reduce__(self) -> tuple[Any, ...]:
        return (_enclosure, (*self._texts(), self._from_floats, self._doubt))

    def __copy__(self) -> Enclosure:
        return self

    def __deepcopy__(self, memo: Any) -> Enclosure:
        return self


def _enclosure(lo: str, hi: str, from_floats: bool, doubt: str | None) -> Enclosure:
    self = Enclosure._of((lo, hi), from_floats)
    self._doubt = doubt
    return self


def _quotients(top: tuple[Fraction, Fraction], bottom: tuple[Fraction, Fraction]) -> list[Fraction]:
    if bottom[0] <= 0 <= bottom[1]:
        raise ZeroDivisionError("division by zero (or by an interval that contains zero)")
    return [x / y for x in top for y in bottom]


def size_ends(lo: Fraction, hi: Fraction) -> list[Fraction]:
    """Numbers whose hull is that of the absolute values from ``lo`` to ``hi``."""
    return [abs(lo), abs(hi), *([Fraction(0)] if lo < 0 < hi else [])]


def power_ends(lo: Fraction, hi: Fraction, exponent: int) -> list[Fraction]:
    """Numbers whose hull is that of the powers of the numbers from ``lo`` to ``hi``; the exponent is not negative."""
    is_even = exponent > 0 and exponent % 2 == 0
    return [lo**exponent, hi**exponent, *([Fraction(0)] if is_even and lo < 0 < hi else [])]


#: Python converts no longer integers from and to texts at once.
_CHUNK = 4000


def read_decimal(text: str) -> Fraction:
    """A decimal of any length."""
    if len(text) <= _CHUNK:
        return Fraction(text)
    mantissa, _, exponent = text.partition("e")
    before, _, after = mantissa.lstrip("-").partition(".")
    number = 0
    for start in range(0, len(before + after), _CHUNK):
        part = (before + after)[start : start + _CHUNK]
        number = number * 10 ** len(part) + int(part)
    value = number * Fraction(10) ** (int(exponent or 0) - len(after))
    return -value if text.startswith("-") else value


def integer_text(n: int) -> str:
    """An integer of any length in decimal."""
    if n.bit_length() < 3 * _CHUNK:
        return str(n)
    if n < 0:
        return "-" + integer_text(-n)
    # Halves keep the divisions few and of equal length.
    places = n.bit_length() * 3 // 20
    high, low = divmod(n, 10**places)
    return integer_text(high) + integer_text(low).rjust(places, "0")


def fraction_text(x: Fraction) -> str:
    """A fraction of any length as ``p/q``."""
    return integer_text(x.numerator) + ("" if x.denominator == 1 else f"/{integer_text(x.denominator)}")


def _text(x: Fraction) -> str:
    """A decimal where there is a finite one of moderate length, otherwise the fraction: always exactly the number."""
    twos = (x.denominator & -x.denominator).bit_length() - 1
    rest = x.denominator >> twos
    fives = 0
    while rest % 5 == 0:
        rest //= 5
        fives += 1
    places = max(twos, fives)
    if rest != 1 or places > 60:
        return fraction_text(x)
    digits = f"{abs(x.numerator) * 10**places // x.denominator:0{places + 1}d}"
    sign = "-" if x < 0 else ""
    return sign + (f"{digits[:-places]}.{digits[-places:]}" if places else digits)


class ExactMatrix(Sequence[tuple[Fraction, ...]]):
    """A matrix of rationals: integers over one common denominator.

    ``matrix[i, j]`` is an entry and ``matrix[i]`` a row, counted from 0; ``numpy.asarray(matrix)`` rounds each entry
    to the nearest double.

    Attributes
    ----------
    shape : tuple of int
        Rows and columns.
    numerators : tuple of int
        Row by row.
    denominator : int
        Above 0, the same for all entries.

    Examples
    --------
    >>> m = ExactMatrix(2, 2, [1, 1, 0, 2], 2)
    >>> m[0, 1], m.shape, m.tolist()[1]
    (Fraction(1, 2), (2, 2), [Fraction(0, 1), Fraction(1, 1)])
    """

    __slots__ = ("denominator", "from_floats", "numerators", "shape")

    def __init__(
        self,
        rows: int,
        columns: int,
        numerators: Sequence[int],
        denominator: int = 1,
        from_floats: tuple[str, ...] = (),
    ) -> None:
        self.shape = (rows, columns)
        self.numerators = tuple(numerators)
        self.denominator = denominator
        self.from_floats = from_floats
        for sentence in from_floats:
            float_seen(sentence)
        if len(self.numerators) != rows * columns:
            raise ValueError(f"{len(self.numerators)} entries do not fill a matrix of {rows} x {columns}")
        if denominator <= 0:
            raise ValueError("the common denominator must be above 0")

    def __len__(self) -> int:
        return self.shape[0]

    def _repr_latex_(self) -> str | None:
        # A larger one fills more than a page: then its text is shown.
        if max(self.shape) > 12:
            return None
        rows = r" \\ ".join(" & ".join(latex(x) for x in row) for row in self)
        return rf"$\begin{{pmatrix}} {rows} \end{{pmatrix}}$"

    def _entry(self, k: int) -> Known:
        return Known(self.numerators[k], self.denominator, bool(self.from_floats))

    def _row(self, i: int) -> tuple[Fraction, ...]:
        width = self.shape[1]
        return tuple(self._entry(i * width + j) for j in range(width))

    @overload
    def __getitem__(self, index: SupportsIndex) -> tuple[Fraction, ...]: ...
    @overload
    def __getitem__(self, index: slice) -> list[tuple[Fraction, ...]]: ...
    @overload
    def __getitem__(self, index: tuple[SupportsIndex, SupportsIndex]) -> Fraction: ...
    def __getitem__(self, index: Any) -> Any:
        rows = range(self.shape[0])
        if isinstance(index, tuple):
            i, j = index
            return self._entry(rows[i] * self.shape[1] + range(self.shape[1])[j])
        if isinstance(index, slice):
            return [self._row(i) for i in rows[index]]
        return self._row(rows[index])

    def tolist(self) -> list[list[Fraction]]:
        """The rows as lists of fractions."""
        return [list(row) for row in self]

    def __iter__(self) -> Iterator[tuple[Fraction, ...]]:
        return (self._row(i) for i in range(self.shape[0]))

    def __array__(self, dtype: npt.DTypeLike | None = None, copy: bool | None = None) -> npt.NDArray[Any]:
        values = [x / self.denominator for x in self.numerators]
        return np.array(values, dtype=dtype or np.float64).reshape(self.shape)

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, ExactMatrix):
            return NotImplemented
        a, b = self.denominator, other.denominator
        pairs = zip(self.numerators, other.numerators, strict=False)
        return self.shape == other.shape and all(x * b == y * a for x, y in pairs)

    def __hash__(self) -> int:
        return hash((self.shape, tuple(Fraction(x, self.denominator) for x in self.numerators)))

    def __repr__(self) -> str:
        rows = [", ".join(str(x) for x in row) for row in self[:8]]
        more = f"\n  .. {self.shape[0]} rows" if self.shape[0] > 8 else ""
        return f"ExactMatrix {self.shape[0]} x {self.shape[1]}\n" + "\n".join(f"  [{row}]" for row in rows) + more

    def __reduce__(self) -> tuple[Any, ...]:
        return (ExactMatrix, (*self.shape, self.numerators, self.denominator, self.from_floats))


def over_common_denominator(values: Any, name: str) -> tuple[list[int], int]:
    """A flat list of numbers as integers over one denominator; arrays without a loop for each conversion."""
    if isinstance(values, np.ndarray):
        if values.dtype.kind in "iub":
            return [int(x) for x in values.ravel().tolist()], 1
        if values.dtype.kind == "f":
            return _doubles(np.asarray(values, dtype=np.float64).ravel(), name)
        if values.dtype.kind != "O":
            raise TypeError(f"{name}: an array of {values.dtype} holds no numbers that are read")
        values = values.ravel().tolist()
    ready = [x if type(x) is int or type(x) is Fraction else exact(x, name) for x in values]
    denominator = lcm(*{x.denominator for x in ready}) if ready else 1
    return [x.numerator * (denominator // x.denominator) for x in ready], denominator


def _doubles(values: npt.NDArray[np.float64], name: str) -> tuple[list[int], int]:
    if not np.isfinite(values).all():
        wrong = values[~np.isfinite(values)][0]
        raise ValueError(f"{name}: `{wrong}` is not a number")
    mantissas, exponents = np.frexp(values)
    integers = (mantissas * 2.0**53).astype(np.int64)
    odd = integers != 0
    # An odd integer times a power of two: the shortest denominator.
    lowest = np.where(odd, integers & -integers, 1)
    zeros = np.frexp(lowest.astype(np.float64))[1] - 1
    integers >>= zeros
    powers = exponents.astype(np.int64) - 53 + zeros
    least = min(0, int(powers[odd].min())) if odd.any() else 0
    shifts = np.where(odd, powers - least, 0)
    return [m << s for m, s in zip(integers.tolist(), shifts.tolist(), strict=True)], 1 << -least


def exact_matrix(values: Any, name: str) -> ExactMatrix:
    """A matrix from rows of numbers, an array or an :class:`ExactMatrix`."""
    if isinstance(values, ExactMatrix):
        return values
    floats = (f"{name} holds floats, which stand for their exact values",) if holds_floats(values) else ()
    if hasattr(values, "toarray"):
        values = values.toarray()
    if isinstance(values, np.ndarray):
        if values.ndim != 2:
            raise ValueError(f"{name}: a matrix has 2 dimensions, not {values.ndim}")
        rows, columns = values.shape
        floats = floats or (
            (f"{name} holds floats, which stand for their exact values",) if holds_floats(values) else ()
        )
        integers, denominator = over_common_denominator(values, name)
    else:
        lists = rows_of(values, name)
        rows, columns = len(lists), len(lists[0]) if lists else 0
        for i, row in enumerate(lists):
            if len(row) != columns:
                raise ValueError(f"{name}: row {i + 1} has {len(row)} entries where row 1 has {columns}")
        integers, denominator = over_common_denominator([x for row in lists for x in row], name)
    if rows == 0 or columns == 0:
        raise ValueError(f"{name}: the matrix is empty")
    return ExactMatrix(rows, columns, integers, denominator, floats)


def rows_of(values: Any, name: str) -> list[list[Any]]:
    """Nested sequences as lists of lists."""
    if isinstance(values, (str, bytes, dict)) or not hasattr(values, "__iter__"):
        raise TypeError(f"{name} should be a list of rows, but it is `{str(values)[:60]}`")
    rows = []
    for row in values:
        if isinstance(row, (str, bytes, dict)) or not hasattr(row, "__iter__"):
            raise TypeError(f"{name} should be a list of rows, but one of them is `{str(row)[:60]}`")
        rows.append(list(row))
    return rows
