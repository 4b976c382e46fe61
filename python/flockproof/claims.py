"""Statements of one's own, judged by the rules of the ledger.

A claim is a statement, variants of it that must fail (negative controls) and a check that decides any variant. The
check computes with :class:`Exact` numbers and hands comparisons, which are :class:`Truth` objects, to its
:class:`Run`; the grade of the evidence follows from what went into them. What passed through a float is at most
``simulated``: a float in an expression marks the result, a plain ``bool`` counts as one of unknown origin, a float
that enters a function of this package marks the whole check, and so does turning an :class:`Exact` into a float. An
``int`` carries no history: do not make integers from floats.

Examples
--------
>>> from flockproof.claims import Exact, claim, verify
>>> statement = "1 + 3 + .. + (2n - 1) = n^2 for every n up to 50."
>>> @claim("school.odd", statement, printed=2, controls={"the cube": 3, "n itself": 1})
... def odd_numbers(exponent, run):
...     "(n + 1)^2 - n^2 = 2n + 1."
...     total = Exact(0)
...     def holds(n):
...         nonlocal total
...         total += 2 * n - 1
...         return total == Exact(n) ** exponent
...     return run.exhaustive("the sums", "added up", range(1, 51), holds)
>>> entry = verify(odd_numbers)["school.odd"]
>>> entry.verdict, entry.grades, entry.controls.refuted, entry.controls.failed[0]
('holds', ('exhaustive',), 2, 'the sums: 2: 4 = 8 does not hold')
"""

from __future__ import annotations

import hashlib
import json
import re
import time
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from math import isqrt
from random import Random
from typing import TYPE_CHECKING, Any, Generic, Literal, TypeVar, cast

import numpy as np

from . import _native
from ._ledger import Entry, Ledger, Text
from ._numbers import (
    Enclosure,
    Number,
    Undecided,
    float_seen,
    floats_seen,
    fraction_text,
    power_ends,
    size_ends,
    why_not_exact,
)
from ._shown import Shown
from ._signatures import readable

if TYPE_CHECKING:
    from ._questions import Question

__all__ = ["Claimed", "Exact", "Outcome", "Run", "Truth", "claim", "every", "some", "verify"]


def __dir__() -> list[str]:
    return sorted(__all__)


#: What a comparison rests on, weakest first.
_STRENGTH = ("simulated", "certified", "exact")
_VERDICTS = ("holds", "needs_hypothesis", "misprint", "false", "undecided", "not_checkable")
_PAPERS = ("chazelle", "veerman", "paley", "tanner1", "tanner2", "beyond")


class Truth:
    """A comparison that knows what it rests on.

    Attributes
    ----------
    value : bool or None
        None where an enclosure is too wide to decide.
    grade : str
        ``exact``, ``certified`` or ``simulated``.
    text : str
        What was compared.
    doubt : str or None
        Why it is simulated.

    Notes
    -----
    ``&``, ``|``, ``~``, :func:`every` and :func:`some` join comparisons. ``not``, ``all`` and ``any`` of Python give
    a plain bool, which counts as simulated.
    """

    __slots__ = ("doubt", "grade", "text", "value")

    def __init__(self, value: bool | None, grade: str, text: str, doubt: str | None = None) -> None:
        self.value = value
        self.grade = grade
        self.text = text
        self.doubt = doubt

    def __bool__(self) -> bool:
        if self.value is None:
            raise Undecided(f"{self.text}: the enclosure is too wide to decide")
        if self.doubt is not None:
            float_seen(self.doubt)
        return self.value

    def _with(self, other: object, value: bool | None, word: str) -> Truth:
        right = _truth(other)
        grade = min(self.grade, right.grade, key=_STRENGTH.index)
        return Truth(value, grade, f"({self.text} {word} {right.text})", self.doubt or right.doubt)

    def __and__(self, other: object) -> Truth:
        values = (self.value, _truth(other).value)
        return self._with(other, False if False in values else None if None in values else True, "and")

    def __or__(self, other: object) -> Truth:
        values = (self.value, _truth(other).value)
        return self._with(other, True if True in values else None if None in values else False, "or")

    __rand__ = __and__
    __ror__ = __or__

    def __invert__(self) -> Truth:
        return Truth(None if self.value is None else not self.value, self.grade, f"not {self.text}", self.doubt)

    def __repr__(self) -> str:
        return f"Truth({self.text}: {self.value}, {self.grade})"


def _truth(value: object) -> Truth:
    if isinstance(value, Truth):
        return value
    if isinstance(value, (bool, np.bool_)):
        doubt = "a plain bool does not say where it comes from"
        return Truth(bool(value), "simulated", str(bool(value)), doubt)
    raise TypeError(f"a comparison is expected, but it is `{str(value)[:60]}`")


def every(truths: Iterable[object]) -> Truth:
    """Whether all hold; the first that does not decides."""
    result = Truth(True, "exact", "all of none")
    for k, truth in enumerate(truths):
        result = _truth(truth) if k == 0 else result & truth
        if result.value is False:
            return _truth(truth)
    return result


def some(truths: Iterable[object]) -> Truth:
    """Whether one holds."""
    result = Truth(False, "exact", "one of none")
    for k, truth in enumerate(truths):
        result = _truth(truth) if k == 0 else result | truth
    return result


class Exact:
    """A number that knows whether a float had a part in it: a rational, or an enclosure between two.

    Parameters
    ----------
    value
        int, str (``"1/3"``, ``"0.1"``), another Exact, or a number that this package computed. A float, Fraction or
        Decimal is taken at its exact value and marks the number: write ``Exact(1, 3)`` or ``Exact("1/3")``.
    denominator
        For ``Exact(1, 3)``.

    Examples
    --------
    >>> Exact(1, 3) + "1/6" == Exact("0.5")
    Truth(1/2 = 1/2: True, exact)
    >>> Exact("0.1") + 0.25 < 1
    Truth(7/20 < 1: True, simulated)
    """

    __slots__ = ("doubt", "hi", "lo")
    lo: Fraction
    hi: Fraction
    doubt: str | None

    def __init__(self, value: Any = 0, denominator: int = 1) -> None:
        if isinstance(value, Exact):
            self.lo, self.hi, self.doubt = value.lo, value.hi, value.doubt
        elif isinstance(value, Enclosure):
            self.lo, self.hi, self.doubt = value.lo, value.hi, why_not_exact(value)
        else:
            self.doubt = why_not_exact(value)
            # The mark stays with this number; the rest of the check is not touched.
            known = isinstance(value, Fraction)
            self.lo = self.hi = Fraction(value) if known else Fraction(*_native.ratio("value", value))
        if denominator != 1:
            self.lo, self.hi = self.lo / denominator, self.hi / denominator
            self.doubt = self.doubt or why_not_exact(denominator)

    @classmethod
    def _between(cls, ends: Sequence[Fraction], doubt: str | None) -> Exact:
        self = cls.__new__(cls)
        self.lo, self.hi, self.doubt = min(ends), max(ends), doubt
        return self

    @property
    def is_exact(self) -> bool:
        """Whether it is one number and no float had a part in it."""
        return self.lo == self.hi and self.doubt is None

    def enclosure(self) -> Enclosure:
        """The number, or what it lies between."""
        found = Enclosure(self.lo, self.hi)
        found._doubt = self.doubt
        return found

    def sqrt(self, digits: int = 30) -> Exact:
        """An enclosure of the square root, about so many digits after the point."""
        if self.lo < 0:
            raise ValueError("the argument of sqrt lies outside its domain")
        scale = 10 ** (2 * digits)
        low = isqrt(self.lo.numerator * scale // self.lo.denominator)
        high = isqrt(-(-self.hi.numerator * scale // self.hi.denominator))
        high += high * high * self.hi.denominator < self.hi.numerator * scale
        return Exact._between([Fraction(low, 10**digits), Fraction(high, 10**digits)], self.doubt)

    def _joined(self, other: Any, ends: Callable[[Exact], list[Fraction]]) -> Exact:
        if not isinstance(other, Exact):
            try:
                other = Exact(other)
            except TypeError:
                return cast("Exact", NotImplemented)
        return Exact._between(ends(other), self.doubt or other.doubt)

    def __add__(self, other: Number | Enclosure | Exact) -> Exact:
        return self._joined(other, lambda y: [self.lo + y.lo, self.hi + y.hi])

    def __sub__(self, other: Number | Enclosure | Exact) -> Exact:
        return self._joined(other, lambda y: [self.lo - y.hi, self.hi - y.lo])

    def __rsub__(self, other: Number | Enclosure | Exact) -> Exact:
        return self._joined(other, lambda y: [y.lo - self.hi, y.hi - self.lo])

    def __mul__(self, other: Number | Enclosure | Exact) -> Exact:
        return self._joined(other, lambda y: [a * b for a in (self.lo, self.hi) for b in (y.lo, y.hi)])

    def __truediv__(self, other: Number | Enclosure | Exact) -> Exact:
        return self._joined(other, lambda y: _quotients(self, y))

    def __rtruediv__(self, other: Number | Enclosure | Exact) -> Exact:
        return self._joined(other, lambda y: _quotients(y, self))

    __radd__ = __add__
    __rmul__ = __mul__

    def __neg__(self) -> Exact:
        return Exact._between([-self.lo, -self.hi], self.doubt)

    def __pos__(self) -> Exact:
        return self

    def __abs__(self) -> Exact:
        return Exact._between(size_ends(self.lo, self.hi), self.doubt)

    def __pow__(self, exponent: int) -> Exact:
        if not isinstance(exponent, (int, np.integer)):
            return NotImplemented
        if exponent < 0:
            return 1 / self ** (-exponent)
        return Exact._between(power_ends(self.lo, self.hi, exponent), self.doubt)

    def _compared(self, other: Any, word: str, answer: Callable[[Exact], bool | None]) -> Truth:
        if not isinstance(other, Exact):
            try:
                other = Exact(other)
            except TypeError:
                return cast("Truth", NotImplemented)
        doubt = self.doubt or other.doubt
        wide = self.lo != self.hi or other.lo != other.hi
        grade = "simulated" if doubt else "certified" if wide else "exact"
        return Truth(answer(other), grade, f"{self} {word} {other}", doubt)

    def __lt__(self, other: Number | Enclosure | Exact) -> Truth:
        return self._compared(other, "<", lambda y: True if self.hi < y.lo else False if self.lo >= y.hi else None)

    def __le__(self, other: Number | Enclosure | Exact) -> Truth:
        return self._compared(other, "<=", lambda y: True if self.hi <= y.lo else False if self.lo > y.hi else None)

    def __gt__(self, other: Number | Enclosure | Exact) -> Truth:
        return self._compared(other, ">", lambda y: True if self.lo > y.hi else False if self.hi <= y.lo else None)

    def __ge__(self, other: Number | Enclosure | Exact) -> Truth:
        return self._compared(other, ">=", lambda y: True if self.lo >= y.hi else False if self.hi < y.lo else None)

    def _equal(self, y: Exact) -> bool | None:
        if self.hi < y.lo or y.hi < self.lo:
            return False
        return True if self.lo == self.hi == y.lo == y.hi else None

    def __eq__(self, other: object) -> Truth:  # type: ignore[override]
        return self._compared(other, "=", self._equal)

    def __ne__(self, other: object) -> Truth:  # type: ignore[override]
        def differs(y: Exact) -> bool | None:
            same = self._equal(y)
            return None if same is None else not same

        return self._compared(other, "!=", differs)

    __hash__ = None  # type: ignore[assignment]

    def _single(self) -> Fraction:
        if self.lo != self.hi:
            raise Undecided(f"{self} is not one number")
        if self.doubt is not None:
            float_seen(self.doubt)
        return self.lo

    def __bool__(self) -> bool:
        return self._single() != 0

    def __int__(self) -> int:
        return int(self._single())

    def __floor__(self) -> int:
        return self._single().__floor__()

    def __ceil__(self) -> int:
        return self._single().__ceil__()

    def __float__(self) -> float:
        float_seen("an exact number was turned into a float")
        return float((self.lo + self.hi) / 2)

    def __str__(self) -> str:
        return fraction_text(self.lo) if self.lo == self.hi else str(Enclosure(self.lo, self.hi))

    def _repr_latex_(self) -> str:
        return self.enclosure()._repr_latex_()

    def __repr__(self) -> str:
        return f"Exact({str(self)!r}{'' if self.doubt is None else f', {self.doubt}'})"


def _quotients(x: Exact, y: Exact) -> list[Fraction]:
    if y.lo <= 0 <= y.hi:
        raise ZeroDivisionError("division by zero (or by an interval that contains zero)")
    return [a / b for a in (x.lo, x.hi) for b in (y.lo, y.hi)]


@dataclass(frozen=True)
class _Evidence:
    grade: str
    part: str
    detail: str
    clauses: tuple[int, ...] = ()
    scope: str = "instances"
    cases: int | None = None


@dataclass(frozen=True, eq=False)
class Outcome:
    """What a check says of one variant: made by the methods of :class:`Run` only."""

    kind: str
    why: str = ""
    evidence: tuple[_Evidence, ...] = ()


class Run:
    """What a check is given: it grades evidence by what went into it.

    Attributes
    ----------
    full : bool
        Whether more cases are wanted.
    """

    def __init__(self, id: str, seed: str, full: bool) -> None:
        self.full = full
        self._name = f"{id}\0{seed}"
        self._values: dict[str, str] = {}
        self._issued: list[Outcome] = []
        self._floats: list[str] = []

    def random(self, replicate: int = 0) -> Random:
        """A generator whose seed depends on the seed of the run, the id of the claim and the replicate only."""
        digest = hashlib.sha256(f"{self._name}\0{replicate}".encode()).digest()
        return Random(int.from_bytes(digest, "big"))

    def cases(self, few: int, many: int) -> int:
        """``few`` cases in an ordinary run, ``many`` in a full one."""
        return many if self.full else few

    def value(self, name: str, number: Any) -> None:
        """Records a number by name: exact, enclosed, or with ``~`` where a float had a part in it."""
        known = Exact(number)
        self._values[name] = f"~{float(known.lo)!r}" if known.doubt else str(known)

    def exhaustive(
        self, part: str, detail: str, cases: Iterable[Any], holds: Callable[[Any], object], clauses: Sequence[int] = ()
    ) -> Outcome:
        """Looks at every case of a finite family, which is all that the clauses speak of: grade ``exhaustive``."""
        return self._looked(part, detail, cases, holds, clauses, "exhaustive", "all")

    def instances(
        self, part: str, detail: str, cases: Iterable[Any], holds: Callable[[Any], object], clauses: Sequence[int] = ()
    ) -> Outcome:
        """Looks at some cases: grade ``exact``, or ``certified`` where an enclosure decides."""
        return self._looked(part, detail, cases, holds, clauses, "exact", "instances")

    def fuzzed(
        self,
        part: str,
        detail: str,
        count: int,
        draw: Callable[[Random], Any],
        holds: Callable[[Any], object],
        clauses: Sequence[int] = (),
    ) -> Outcome:
        """Looks at random cases, each drawn from a generator of its own: grade ``fuzzed``."""
        cases = (draw(self.random(k)) for k in range(count))
        return self._looked(part, detail, cases, holds, clauses, "fuzzed", "instances")

    def argued(self, part: str, place: str, clauses: Sequence[int] = ()) -> Outcome:
        """A proof on paper for all parameters; ``place`` says where it stands, step by step."""
        return self._issue(Outcome("holds", "", (_Evidence("argued", part, place, tuple(clauses), "all"),)))

    def question(
        self,
        part: str,
        question: Question,
        clauses: Sequence[int] = (),
        scope: Literal["all", "instances"] = "instances",
    ) -> Outcome:
        """Decides a question as :func:`flockproof.check` does, of a law of one's own for instance; its grades.

        Parameters
        ----------
        part, clauses
            What it shows, and of which clauses.
        question
            A dictionary or the path of a file; ``[question] law`` may be a :class:`flockproof.Law`. Its own controls
            must be refuted as well, where it has any.
        scope
            ``all`` where the family of the question is all that the clauses speak of.
        """
        from ._questions import check

        if scope not in ("all", "instances"):
            raise ValueError(f"scope should be all or instances, but it is `{str(scope)[:60]}`")
        answer = check(question)
        if answer.verdict in ("undecided", "withheld"):
            return self._issue(Outcome("undecided", f"{part}: {answer.why or answer.verdict}"))
        doubt = self._floats[0] if self._floats else None
        grades = answer.grades if doubt is None else ("simulated",)
        holds = answer.verdict == "holds"
        covered = scope if holds and "simulated" not in grades else "instances"
        detail = _with_doubt("decided as a question", doubt)
        evidence = tuple(_Evidence(grade, part, detail, tuple(clauses), covered, answer.cases) for grade in grades)
        if holds:
            return self._issue(Outcome("holds", "", evidence))
        at = ", ".join(f"{name} = {value}" for name, value in (answer.counterexample or {}).items())
        return self._issue(Outcome("fails", f"{part}: {_shown(at)}: {answer.why}", evidence))

    def undecided(self, why: str) -> Outcome:
        """Neither could be established."""
        return self._issue(Outcome("undecided", why))

    def all(self, *outcomes: Outcome) -> Outcome:
        """The evidence of all parts, or the first one that does not hold."""
        for outcome in outcomes:
            self._check(outcome)
            if outcome.kind != "holds":
                return outcome
        return self._issue(Outcome("holds", "", tuple(e for outcome in outcomes for e in outcome.evidence)))

    def _issue(self, outcome: Outcome) -> Outcome:
        self._issued.append(outcome)
        return outcome

    def _check(self, outcome: object) -> Outcome:
        if not any(outcome is issued for issued in self._issued):
            raise TypeError("a check returns what a method of its run returned")
        assert isinstance(outcome, Outcome)
        return outcome

    def _looked(
        self,
        part: str,
        detail: str,
        cases: Iterable[Any],
        holds: Callable[[Any], object],
        clauses: Sequence[int],
        best: str,
        scope: str,
    ) -> Outcome:
        count, weakest, doubt = 0, "exact", None
        for case in cases:
            try:
                truth = _truth(holds(case))
            except Undecided as error:
                return self._issue(Outcome("undecided", f"{part}: {_shown(case)}: {error}"))
            if self._floats and truth.doubt is None:
                truth = Truth(truth.value, "simulated", truth.text, self._floats[0])
            weakest = min(weakest, truth.grade, key=_STRENGTH.index)
            doubt = doubt or truth.doubt
            if truth.value is None:
                why = f"{part}: {_shown(case)}: {truth.text} is not decided, the enclosure is too wide"
                return self._issue(Outcome("undecided", why))
            if not truth.value:
                failed = _Evidence(truth.grade, part, _with_doubt(detail, truth.doubt), tuple(clauses))
                said = f"{part}: {_shown(case)}: {truth.text} does not hold"
                return self._issue(Outcome("fails", said, (failed,)))
            count += 1
        if count == 0:
            return self._issue(Outcome("undecided", f'no case was looked at for "{part}"'))
        if weakest == "simulated":
            grade, scope = ("fuzzed" if best == "fuzzed" else "simulated"), "instances"
        else:
            grade = weakest if best == "exact" else best
        evidence = _Evidence(grade, part, _with_doubt(detail, doubt), tuple(clauses), scope, count)
        return self._issue(Outcome("holds", "", (evidence,)))


def _with_doubt(detail: str, doubt: str | None) -> str:
    return detail if doubt is None else f"{detail}; at most simulated: {doubt}"


def _shown(case: object) -> str:
    text = str(case)
    return text if len(text) <= 200 else text[:200] + ".."


V = TypeVar("V")
Check = Callable[[V, Run], Outcome]


@dataclass(frozen=True, eq=False)
class Claimed(Shown, Generic[V]):
    """A statement of one's own with its check; :func:`claim` makes it."""

    id: str
    statement: str
    check: Check[V]
    printed: V
    controls: Mapping[str, V] = field(default_factory=dict)
    place: str = "own"
    clauses: tuple[str, ...] = ()
    reading: str | None = None
    repaired: tuple[str, str, V] | None = None
    expected: str | None = None
    expected_grades: tuple[str, ...] = ()

    def verify(self, seed: str = "flockproof", full: bool = False) -> Entry:
        """The entry of the statement."""
        entry: Entry = verify(self, seed=seed, full=full)[self.id]
        return entry

    def explain(self) -> Text:
        """The claim in words."""
        return Text(verify(self)[self.id].derivation)

    def __call__(self, variant: V, run: Run) -> Outcome:
        return self.check(variant, run)

    def __repr__(self) -> str:
        return f"{self.id}: {self.statement}\n  controls {', '.join(self.controls) or 'none'}"

    def _repr_html_(self) -> str:
        from html import escape

        return f"<b>{escape(self.id)}</b><br>{escape(self.statement)}<br>controls: {escape(', '.join(self.controls))}"


def claim(
    id: str,
    statement: str,
    *,
    printed: Any,
    controls: Mapping[str, Any],
    place: str = "own",
    clauses: Sequence[str] = (),
    reading: str | None = None,
    repaired: tuple[str, str, Any] | None = None,
    expected: str | None = None,
    expected_grades: Sequence[str] = (),
) -> Callable[[Callable[[Any, Run], Outcome]], Claimed[Any]]:
    """Make a claim of a function that decides a variant of a statement; its docstring is the argument in words.

    Parameters
    ----------
    id
        Such as ``mine.no_collision``; the first part is the name of the collection, not that of a paper.
    statement, place, clauses, reading
        As printed; where; the sentences that can be true or false alone; how it is read, where that is a choice.
    printed
        The variant that is the statement as printed: anything, handed to the function.
    controls
        What each negative control alters, and its variant. The check must refute all of them.
    repaired
        For a printed statement that fails: its fault (``hypothesis``, ``typo``, ``slip`` or ``false``), the corrected
        statement, and its variant.
    expected, expected_grades
        The verdict that is recorded, ``holds``, ``needs_hypothesis``, ``misprint``, ``false``, ``undecided`` or
        ``not_checkable``, and the grades, of ``identity``, ``argued``, ``exhaustive``, ``certified``, ``exact``,
        ``simulated`` and ``fuzzed``; others are a difference.

    Returns
    -------
    callable
        A decorator, which gives a :class:`Claimed`.

    Raises
    ------
    ValueError, TypeError
        An id or fault that is none.
    """
    if not isinstance(id, str) or not re.fullmatch(r"[a-z][A-Za-z0-9_]*(\.[A-Za-z0-9_]+)+", id):
        raise ValueError(f"`{id}` is no id: it should be like mine.no_collision")
    if id.split(".", maxsplit=1)[0] in _PAPERS:
        raise ValueError(f"`{id}` begins with the name of a paper")
    if not isinstance(statement, str) or not statement:
        raise TypeError("the statement should be a text")
    if not isinstance(controls, Mapping) or not all(isinstance(what, str) for what in controls):
        raise TypeError(f"controls should be a dictionary of texts and variants, but it is `{str(controls)[:60]}`")
    for name, texts in (("clauses", clauses), ("expected_grades", expected_grades)):
        if not isinstance(texts, (list, tuple)) or not all(isinstance(text, str) for text in texts):
            raise TypeError(f"{name} should be a list of texts, but it is `{str(texts)[:60]}`")
    if expected is not None and expected not in _VERDICTS:
        raise ValueError(f"expected should be one of {', '.join(_VERDICTS)}, but it is `{str(expected)[:60]}`")
    faults = ("hypothesis", "typo", "slip", "false")
    if repaired is not None and (not isinstance(repaired, tuple) or len(repaired) != 3 or repaired[0] not in faults):
        raise ValueError(
            "repaired should be (fault, statement, variant) with the fault hypothesis, typo, slip or false"
        )

    def decorate(check: Check[Any]) -> Claimed[Any]:
        return Claimed(
            id,
            statement,
            check,
            printed,
            dict(controls),
            place,
            tuple(clauses),
            reading,
            repaired,
            expected,
            tuple(expected_grades),
        )

    return decorate


def verify(*claims: Claimed[Any], seed: str = "flockproof", full: bool = False) -> Ledger:
    """Examine the statements, corrections and controls of claims, and judge them by the rules of the ledger.

    Checks run in this thread, one after the other. Corrections become claims of their own, ``beyond.`` and the id.

    Parameters
    ----------
    claims
        Made by :func:`claim`.
    seed
        Of ``run.random`` and of everything drawn.
    full
        Whether checks are asked for more cases.

    Returns
    -------
    Ledger
        With the same JSON as that of the papers. ``differences`` lists controls that were not refuted, missing
        controls, clauses without evidence and verdicts that are not the expected ones.

    Raises
    ------
    TypeError
        What is no claim. What a check raises is part of its entry.
    """
    documents, seconds = [], {}
    for one in claims:
        if not isinstance(one, Claimed):
            raise TypeError(f"`{str(one)[:60]}` is no claim: decorate the check with @claim(..)")
        started = time.perf_counter()
        documents.append(_examined(one, seed, full))
        seconds[one.id] = seconds[f"beyond.{one.id}"] = time.perf_counter() - started
    text, differences, missing, table, explanations = _native.judge(json.dumps(documents), seed)
    document = json.loads(text)
    for entry in document["claims"]:
        entry["seconds"] = seconds[entry["id"]]
    text = json.dumps(document, indent=2, ensure_ascii=False) + "\n"
    return Ledger((text, differences, missing, table, explanations))


def _examined(one: Claimed[Any], seed: str, full: bool) -> dict[str, Any]:
    def examine(variant: Any, stated: bool) -> dict[str, Any]:
        run = Run(one.id, seed, full)
        token = floats_seen.set(run._floats)
        try:
            outcome = run._check(one.check(variant, run))
        except Undecided as error:
            outcome = Outcome("undecided", str(error))
        except Exception as error:
            outcome = Outcome("error", f"{type(error).__name__}: {error}")
        finally:
            floats_seen.reset(token)
        simulated = any(e.grade == "simulated" for e in outcome.evidence)
        if stated and outcome.kind == "fails" and simulated:
            # Floats propose; a verdict against a statement needs more.
            outcome = Outcome("undecided", f"floating point suggests a counterexample: {outcome.why}")
        return {
            "outcome": outcome.kind,
            "why": outcome.why,
            "evidence": [vars(e) for e in outcome.evidence],
            "values": run._values,
        }

    document: dict[str, Any] = {
        "id": one.id,
        "place": one.place,
        "statement": one.statement,
        "derivation": " ".join((one.check.__doc__ or "").split()),
        "clauses": one.clauses,
        "reading": one.reading,
        "correction": None,
        "expected": one.expected,
        "expected_grades": one.expected_grades,
        "printed": examine(one.printed, True),
        "corrected": None,
        "controls": [{"what": what, "outcome": examine(v, False)} for what, v in one.controls.items()],
    }
    if one.repaired is not None:
        fault, statement, variant = one.repaired
        document["correction"] = {"fault": fault, "statement": statement, "clauses": []}
        document["corrected"] = examine(variant, True)
    return document


readable(globals(), __all__)
