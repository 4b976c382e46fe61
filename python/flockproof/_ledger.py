"""The ledger: what the papers claim, and what was found."""

from __future__ import annotations

import json
import os
import shutil
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from html import escape
from pathlib import Path
from typing import TYPE_CHECKING, Any

from . import _native
from ._extras import needed
from ._progress import Progress, callback
from ._shown import Shown, table

if TYPE_CHECKING:
    import pandas


class Text(str):
    """A text that shows itself with its lines."""

    __slots__ = ()

    def __repr__(self) -> str:
        return str(self)


@dataclass(frozen=True)
class Claim(Shown):
    """A claim of the papers, or a result of this project, with the verdict that is recorded for it.

    Attributes
    ----------
    id, paper, place, statement : str
        The paper is the first part of the id.
    verdict : str
        ``holds``, ``needs_hypothesis``, ``misprint``, ``false``, ``undecided`` or ``not_checkable``.
    fault : str or None
        ``hypothesis``, ``typo``, ``slip`` or ``false``.
    covered, clauses : int
        How many clauses are covered for all parameters, of how many.
    grades : tuple of str
        Grades of the evidence, strongest first.
    """

    id: str
    paper: str
    place: str
    statement: str
    verdict: str
    fault: str | None
    covered: int
    clauses: int
    grades: tuple[str, ...]

    def verify(self, seed: str = "flockproof", full: bool = False) -> Entry:
        """Runs the check of the claim."""
        entry: Entry = verify(claims=[self.id], seed=seed, full=full)[0]
        return entry

    def explain(self) -> Text:
        """The claim in words."""
        return explain(self.id)

    def __repr__(self) -> str:
        return f"{self.id} ({self.place}): {self.verdict}\n  {self.statement}"

    def _repr_html_(self) -> str:
        return _heading(self)


class Claims(Shown, Sequence[Claim]):
    """Claims by number or id.

    Examples
    --------
    >>> claims = ledger()
    >>> claims["veerman.lem2"].verdict
    'holds'
    """

    def __init__(self, claims: Iterable[Claim]) -> None:
        self._all = tuple(claims)
        if not all(isinstance(claim, Claim) for claim in self._all):
            raise TypeError(f"claims should be those of ledger(), but they are `{str(self._all)[:60]}`")
        self._by_id = {claim.id: claim for claim in self._all}

    def __getitem__(self, key: Any) -> Any:
        if isinstance(key, str):
            try:
                return self._by_id[key]
            except KeyError:
                raise ValueError(f"there is no claim {key}") from None
        found = self._all[key]
        return Claims(found) if isinstance(key, slice) else found

    def __len__(self) -> int:
        return len(self._all)

    def __iter__(self) -> Iterator[Claim]:
        return iter(self._all)

    def __contains__(self, key: object) -> bool:
        return key in self._by_id or key in self._all

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Claims) and self._all == other._all

    def __hash__(self) -> int:
        return hash(self._all)

    def paper(self, name: str) -> Claims:
        """The claims of one paper."""
        papers = sorted({claim.paper for claim in self._all})
        if name not in papers:
            raise ValueError(f"there is no paper {name}; there are {', '.join(papers)}")
        return Claims(claim for claim in self._all if claim.paper == name)

    def to_pandas(self) -> pandas.DataFrame:
        """A row for each claim."""
        needed("pandas", "pandas")
        import pandas

        names = ["id", "paper", "place", "statement", "verdict", "fault", "covered", "clauses", "grades"]
        rows = [[*(getattr(claim, name) for name in names[:-1]), ",".join(claim.grades)] for claim in self._all]
        return pandas.DataFrame(rows, columns=pandas.Index(names)).set_index("id")

    def __repr__(self) -> str:
        counts = Counter(claim.verdict for claim in self._all)
        return f"{len(self)} claims: " + ", ".join(f"{n} {verdict}" for verdict, n in counts.most_common())

    def _repr_html_(self) -> str:
        cells = [(c.id, c.place, c.verdict, ", ".join(c.grades), c.statement) for c in self._all]
        return table(("claim", "place", "recorded verdict", "evidence", "statement"), cells)


def _heading(of: Claim | Entry) -> str:
    name = f"<b>{escape(of.id)}</b> ({escape(of.place)}): <i>{escape(of.verdict)}</i>"
    return f"{name}<br>{escape(of.statement)}"


def ledger() -> Claims:
    """All claims with the verdicts that are recorded; nothing is run. :func:`verify` runs the checks.

    Returns
    -------
    Claims
        By number or id, with ``to_pandas()``.

    Examples
    --------
    >>> len(ledger()) > 100
    True
    """
    claims = []
    for name, place, statement, verdict, fault, reach, grades in _native.claims():
        covered, _, clauses = reach.partition("/")
        known = tuple(grade for grade in grades.split(",") if grade)
        paper = name.partition(".")[0]
        counts = (int(covered or 0), int(clauses or 0))
        claims.append(Claim(name, paper, place, statement, verdict, None if fault == "-" else fault, *counts, known))
    return Claims(claims)


@dataclass(frozen=True)
class Evidence(Shown):
    """One piece of evidence.

    Attributes
    ----------
    grade : str
        ``kernel``, ``identity``, ``exhaustive``, ``certified``, ``argued``, ``exact``, ``simulated``, ``fuzzed`` or
        ``text``.
    clauses : tuple of int
        Those that it bears on, from 1.
    scope : str or None
        ``all`` parameters or ``instances``.
    part, detail : str
        What was looked at, and what was done.
    cases : int or None
    error_bound : str or None
        Of random identity tests.
    """

    grade: str
    clauses: tuple[int, ...]
    scope: str | None
    part: str
    detail: str
    cases: int | None
    error_bound: str | None

    def _cells(self) -> tuple[str, str, str, str]:
        return self.grade, ", ".join(map(str, self.clauses)), self.part, self.detail

    def _repr_html_(self) -> str:
        known = (("scope", self.scope), ("cases", self.cases), ("bound of the error", self.error_bound))
        told = "".join(f"<br>{escape(name)}: {escape(str(value))}" for name, value in known if value is not None)
        return table(_EVIDENCE, [self._cells()]) + f"<p>{told.removeprefix('<br>')}</p>" * bool(told)


#: The head of a table of evidence.
_EVIDENCE = ("grade", "clauses", "part", "what was done")


@dataclass(frozen=True)
class Controls:
    """What became of the negative controls: how many were refuted, what each alters, where each failed."""

    refuted: int
    total: int
    what: tuple[str, ...]
    failed: tuple[str, ...]


@dataclass(frozen=True)
class Entry(Shown):
    """What was found about one claim; the fields are those of the JSON of ``verify --json``."""

    id: str
    paper: str
    place: str
    statement: str
    clauses: tuple[str, ...]
    clause_verdicts: tuple[str | None, ...]
    reading: str | None
    verdict: str
    fault: str | None
    corrected: str | None
    counterexample: str | None
    witnesses: tuple[Mapping[str, Any], ...] = field(hash=False)
    evidence: tuple[Evidence, ...]
    controls: Controls
    values: Mapping[str, str] = field(hash=False)
    why: str | None
    seconds: float = field(compare=False)
    derivation: str = field(compare=False, default="")

    @property
    def grades(self) -> tuple[str, ...]:
        """The distinct grades, strongest first."""
        order = ("kernel", "identity", "exhaustive", "certified", "argued", "exact", "simulated", "fuzzed", "text")
        return tuple(grade for grade in order if any(e.grade == grade for e in self.evidence))

    def __repr__(self) -> str:
        lines = [f"{self.id} ({self.place}): {self.verdict}", f"  {self.statement}"]
        named = [("counterexample", self.counterexample), ("corrected", self.corrected), ("why", self.why)]
        lines += [f"  {name}: {text}" for name, text in named if text]
        lines += [f"  {e.grade}: {e.part} ({e.detail})" for e in self.evidence]
        return "\n".join([*lines, f"  controls {self.controls.refuted}/{self.controls.total}"])

    def _repr_html_(self) -> str:
        rows = [e._cells() for e in self.evidence]
        head = _heading(self)
        told = "".join(f"<br>{escape(text)}" for text in (self.counterexample, self.corrected, self.why) if text)
        controls = f"<p>controls {self.controls.refuted}/{self.controls.total}</p>"
        return head + told + table(_EVIDENCE, rows) + controls


def _entry(found: dict[str, Any], derivation: str) -> Entry:
    evidence = tuple(Evidence(**{**e, "clauses": tuple(e["clauses"])}) for e in found["evidence"])
    c = found["controls"]
    controls = Controls(c["refuted"], c["total"], tuple(c["what"]), tuple(c["failed"]))
    lists: dict[str, Any] = {k: tuple(found[k]) for k in ("clauses", "clause_verdicts", "witnesses")}
    rest = {k: v for k, v in found.items() if k not in ("evidence", "controls", *lists)}
    return Entry(evidence=evidence, controls=controls, derivation=derivation, **lists, **rest)


class Ledger(Shown, Sequence[Entry]):
    """A ledger that was run: entries by number or id.

    Attributes
    ----------
    differences : tuple of str
        Where it is not as recorded, a control was not refuted, or more is said than the evidence bears.
    table : str
        What the command line prints.
    """

    def __init__(self, found: tuple[str, list[str], list[str], str, list[tuple[str, str]]]) -> None:
        self._json, differences, missing, table, derivations = found
        self.differences = tuple(differences)
        self.missing = tuple(missing)
        self.table = Text(table)
        words = dict(derivations)
        document = json.loads(self._json)
        self.seed: str = document["seed"]
        self.version: str = document["version"]
        self._all = tuple(_entry(entry, words.get(entry["id"], "")) for entry in document["claims"])
        self._by_id = {entry.id: entry for entry in self._all}

    @property
    def as_recorded(self) -> bool:
        """Whether every claim reached its recorded verdict with all controls refuted."""
        return not self.differences and not self.missing

    def __getitem__(self, key: Any) -> Any:
        if isinstance(key, str):
            try:
                return self._by_id[key]
            except KeyError:
                raise ValueError(f"there is no claim {key} in this ledger") from None
        return self._all[key]

    def __len__(self) -> int:
        return len(self._all)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Ledger) and (self._all, self.seed) == (other._all, other.seed)

    def __hash__(self) -> int:
        return hash((self._all, self.seed))

    def to_json(self) -> str:
        """The document of ``verify --json``, schema flockproof.ledger/2."""
        return self._json

    def save(self, path: str | os.PathLike[str]) -> None:
        """Writes the JSON document."""
        Path(path).write_text(self._json, encoding="utf-8")

    def to_pandas(self) -> pandas.DataFrame:
        """A row for each claim."""
        needed("pandas", "pandas")
        import pandas

        names = [
            "id",
            "paper",
            "place",
            "statement",
            "verdict",
            "fault",
            "corrected",
            "counterexample",
            "why",
            "seconds",
        ]
        more = ["grades", "controls"]
        rows = [
            [*(getattr(e, name) for name in names), ",".join(e.grades), f"{e.controls.refuted}/{e.controls.total}"]
            for e in self._all
        ]
        return pandas.DataFrame(rows, columns=pandas.Index(names + more)).set_index("id")

    def __repr__(self) -> str:
        told = [f"DIFFERS {difference}" for difference in self.differences]
        missing = [f"interrupted: missing: {', '.join(self.missing)}"] if self.missing else []
        return "\n".join([self.table.rstrip("\n"), *told, *missing])

    def _repr_html_(self) -> str:
        cells = [
            (e.id, e.place, e.verdict, ", ".join(e.grades), f"{e.controls.refuted}/{e.controls.total}", e.statement)
            for e in self._all
        ]
        told = "".join(f"<p>differs: {escape(difference)}</p>" for difference in self.differences)
        return table(("claim", "place", "verdict", "evidence", "controls", "statement"), cells) + told


def _names(names: str | Iterable[str], what: str) -> list[str]:
    if isinstance(names, str):
        return [names]
    if not hasattr(names, "__iter__"):
        raise TypeError(f"{what} should be a name or a list of names, but it is `{str(names)[:60]}`")
    listed = list(names)
    if not all(isinstance(name, str) for name in listed):
        raise TypeError(f"{what} should be a list of names, but it is `{str(names)[:60]}`")
    return listed


def verify(
    papers: str | Iterable[str] = (),
    claims: str | Iterable[str] = (),
    *,
    seed: str = "flockproof",
    full: bool = False,
    threads: int | None = None,
    progress: Progress = None,
) -> Ledger:
    """Run the checks of the ledger; of all claims where none and no paper is named.

    Parameters
    ----------
    papers, claims
        ``chazelle``, ``veerman``, ``paley``, ``tanner1``, ``tanner2``, ``beyond``; ids such as ``veerman.lem2``. With
        both, the named claims of these papers.
    seed
        Of everything random.
    full
        Try more cases; may take minutes.
    threads
        Claims checked at a time.
    progress
        Called with (stage, done, total), or True.

    Returns
    -------
    Ledger
        An entry for each claim; ``differences`` says where it is not as recorded.

    Raises
    ------
    ValueError, TypeError
        A paper or claim that is not there, with the nearest ones.

    Notes
    -----
    Evidence of grade ``kernel`` rests on the transcript of Coq that comes with the package; all else is computed.
    ``notes/guarantees.md`` says what verdicts and grades mean.

    Examples
    --------
    >>> entry = verify(claims="veerman.lem2")[0]
    >>> entry.verdict, entry.controls.refuted == entry.controls.total
    ('holds', True)
    """
    if not isinstance(seed, str):
        raise TypeError(f"seed should be a text, but it is `{str(seed)[:60]}`")
    named = (_names(papers, "papers"), _names(claims, "claims"))
    return Ledger(_native.verify(*named, seed, bool(full), threads, callback(progress)))


def explain(id: str) -> Text:
    """One claim in words: statement, verdict, derivation, evidence, counterexample, correction. It is checked anew.

    Parameters
    ----------
    id
        Such as ``"veerman.lem2"``; ``ledger()`` has all.

    Returns
    -------
    Text
        As wide as the terminal, at most 100 columns.

    Raises
    ------
    ValueError, TypeError
        No such claim; the nearest ids are told.

    Examples
    --------
    >>> print(explain("veerman.lem2").splitlines()[0])
    veerman.lem2  (Lemma 2)
    """
    if not isinstance(id, str):
        raise TypeError(f"id should be a text, but it is `{str(id)[:60]}`")
    return Text(_native.explain(id, min(100, shutil.get_terminal_size().columns)))
