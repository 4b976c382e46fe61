"""Statements of one's own: decide them, tabulate them, attack them; on this machine or on a Dask cluster."""

from __future__ import annotations

import io
import json
import os
import re
import shutil
import tempfile
import uuid
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field
from fractions import Fraction
from pathlib import Path
from typing import TYPE_CHECKING, Any, cast

from . import _native
from ._extras import needed
from ._flock import _refused
from ._graphs import networkx_graph, read_member
from ._numbers import Enclosure, Known, exact, is_float, read_decimal
from ._progress import Progress, callback
from ._runs import toml
from ._shown import ROWS, Shown, table, told
from .law import Law

if TYPE_CHECKING:
    import pandas

Question = Mapping[str, Any] | str | os.PathLike[str]
Plan = dict[str, Any]


@dataclass(frozen=True)
class Member:
    """A member of a family with what decides there.

    Attributes
    ----------
    names : dict
        What the names stand for, as texts; :func:`flockproof.spectrum` reads those of graphs.
    inequality, left, right : str or None
        The inequality that decides, with the values of its sides; None where none does.
    margin : Enclosure or None
        The margin of the property there.
    """

    names: Mapping[str, str] = field(hash=False)
    inequality: str | None
    left: str | None
    right: str | None
    margin: Enclosure | None


@dataclass(frozen=True)
class Answer(Shown):
    """What is known about a statement.

    Attributes
    ----------
    id, verdict, why : str
        The verdict is ``holds``, ``false``, ``undecided``, or ``withheld`` where a control was not refuted.
    grades : tuple of str
        ``exhaustive``, ``certified`` or ``exact``: a sample never gives ``holds``. ``simulated`` where a function of
        ``define`` gave floats.
    counterexample : dict or None
        What the names stand for where the property fails, as texts.
    replay : str or None
        The question of that one instance; :func:`check` decides it again.
    margin : Enclosure or None
        The smallest margin of all cases that were looked at; of a counterexample its own.
    inequalities : dict
        The same of each inequality of the property by itself, under the time operators around it; None where it is not
        bounded.
    cases, undecided, controls_refuted, controls_total : int
    controls_made : tuple of str or None
        The controls that the program made, where the question has none.
    counterexamples, tight : tuple of Member
        What was asked for: counterexamples, and members at which an inequality of the property is an equation.
    attained : dict or None
        A point of a continuum at which the smallest margin is 0, as texts: ``'1/2'``, ``'log(2)'``, or ends of an
        enclosure, ``'[1.2599, 1.26]'``.
    open : dict or None
        What stayed open of a continuum: its ``share`` of the volume, a float as a text such as ``~1.556e-2``, or None
        where there is no volume, and ``boxes`` of it.
    """

    id: str
    verdict: str
    why: str
    grades: tuple[str, ...]
    counterexample: Mapping[str, str] | None = field(hash=False)
    replay: str | None
    margin: Enclosure | None
    inequalities: Mapping[str, Enclosure | None] = field(hash=False)
    cases: int
    undecided: int
    controls_refuted: int
    controls_total: int
    controls_made: tuple[str, ...] | None = None
    counterexamples: tuple[Member, ...] = ()
    tight: tuple[Member, ...] = ()
    text: str = field(compare=False, default="")
    attained: Mapping[str, str] | None = field(hash=False, default=None)
    open: Mapping[str, Any] | None = field(hash=False, default=None)

    def __repr__(self) -> str:
        return self.text.rstrip("\n")

    def _repr_html_(self) -> str:
        from html import escape

        return f"<pre>{escape(self.text)}</pre>"


def check(
    question: Question,
    progress: Progress = None,
    *,
    define: Mapping[str, str | Callable[[Any], Any]] | None = None,
    counterexamples: int = 0,
    tight: int = 0,
) -> Answer:
    """Decide a statement of one's own.

    Parameters
    ----------
    question
        The path of a question file, or the same as a dictionary; ``notes/questions.md`` has the language.
    progress
        Called with (stage, done, total), or True.
    define
        Names that the property may use: expressions as in ``[define]``, or functions of a graph of networkx with the
        vertices 1 to n. A function that gives int or Fraction is exact; where it gives floats the answer is
        ``undecided``, with what they say. None, or an exception, is a value that is missing.
    counterexamples, tight
        How many counterexamples, and members at which an inequality of the property is an equation, are listed at most.

    Returns
    -------
    Answer
        Verdict, grades, counterexample.

    Raises
    ------
    ValueError, TypeError
        What is no question, with the place at fault.
    OSError
        A file that cannot be read.

    Examples
    --------
    >>> answer = check({
    ...     "question": {"id": "mine.edges", "statement": "A tree on n vertices has n edges."},
    ...     "for": {"n": "1..5", "graph": "trees(n)"},
    ...     "holds": {"property": "edges = n", "controls": ["edges > n"]},
    ... })
    >>> answer.verdict, answer.counterexample["n"]
    ('false', '1')
    """
    functions = [(key, _measure(own)) for key, own in (define or {}).items() if callable(own)]
    texts = {key: own for key, own in (define or {}).items() if not callable(own)}
    question = _defining(question, texts, "a function of a graph, or an expression where the question is a dictionary")
    text, files, name = _read(question)
    with _named(name):
        document, words, replay = _native.check(text, files, callback(progress), functions, counterexamples, tight)
    found = json.loads(document)
    made = found["controls"].get("what")
    return Answer(
        found["id"],
        found["verdict"],
        found["why"],
        tuple(found["grades"]),
        found["counterexample"],
        replay,
        _enclosed(found["margin"]),
        {own["inequality"]: _enclosed(own["margin"]) for own in found["inequalities"]},
        found["cases"],
        found["undecided"],
        found["controls"]["refuted"],
        found["controls"]["total"],
        None if made is None else tuple(made),
        _members(found.get("counterexamples")),
        _members(found.get("tight")),
        words,
        found["attained"],
        found["open"],
    )


def _defining(question: Question, texts: Mapping[str, Any], kinds: str) -> Question:
    """The question with expressions by name in ``[define]``."""
    for key, own in texts.items():
        if not isinstance(own, str) or not isinstance(question, Mapping):
            raise TypeError(f"define: `{key}` should be {kinds}, but it is `{str(own)[:60]}`")
        question = {**question, "define": {**question.get("define", {}), key: own}}
    return question


def _members(listed: Mapping[str, Any] | None) -> tuple[Member, ...]:
    def member(own: Mapping[str, Any]) -> Member:
        sides = own["decisive"] or {}
        texts = (sides.get("inequality"), sides.get("left"), sides.get("right"))
        return Member(own["member"], *texts, _enclosed(own["margin"]))

    return tuple(member(own) for own in listed["members"]) if listed else ()


def _measure(function: Callable[[Any], Any]) -> Callable[..., tuple[str, int, int, str]]:
    """A function of a graph as the native half calls it."""

    def measured(member: str) -> tuple[str, int, int, str]:
        try:
            value = function(networkx_graph(*read_member(member)))
            if value is None:
                return "missing", 0, 1, "the function gave None"
            number = exact(int(value) if isinstance(value, bool) else value)
        except Exception as error:
            return "missing", 0, 1, f"{type(error).__name__}: {error}"
        return "float" if is_float(value) else "exact", number.numerator, number.denominator, ""

    return measured


def graphs(family: str, *numbers: int, edges: bool = False) -> Iterator[Any]:
    """The graphs of a family, one of each isomorphism class, in order of size.

    Parameters
    ----------
    family
        ``connected``, ``all``, ``trees``, ``bipartite``, ``planar``, ``regular`` or ``digraphs``, or a text such as
        ``"hypercube:3"``.
    numbers
        The number of vertices, and of ``regular`` the degree.
    edges
        Whether edges are given in the place of graphs of networkx.

    Returns
    -------
    iterator
        Graphs of networkx on the vertices 1 to n, or (order, list of edges); directed ones of ``digraphs``. Weights
        stand in ``weight``, or as third of an edge, where a graph has other ones than 1.

    Raises
    ------
    ValueError, TypeError
        An unknown family, or a size that is not gone through.

    Examples
    --------
    >>> sum(1 for _ in graphs("connected", 6, edges=True))
    112
    >>> next(graphs("regular", 5, 4, edges=True))[0]
    5
    """
    text = f"{family}({', '.join(str(int(number)) for number in numbers)})" if numbers else family
    try:
        found = _native.graphs(text, None)
    except ValueError as error:
        raise ValueError(re.sub(r"^line \d+(, column \d+)?: ", "graphs: ", str(error))) from None

    def one(member: str) -> Any:
        order, pairs, directed = read_member(member)
        return (order, pairs) if edges else networkx_graph(order, pairs, directed)

    return map(one, found)


def _enclosed(margin: Mapping[str, str] | None) -> Enclosure | None:
    return None if margin is None else Enclosure._of((margin["lo"], margin["hi"]))


def _read(question: Question) -> tuple[str, dict[str, str], str | None]:
    """The text of a question, the files that it names, and the path that errors begin with."""
    files: dict[str, str] = {}
    if isinstance(question, Mapping):
        head = question.get("question")
        if isinstance(head, Mapping) and isinstance(head.get("law"), Law):
            files["law.toml"] = head["law"].to_toml()
            question = {**question, "question": {**head, "law": "law.toml"}}
        text, folder, name = toml(question), Path(), None
    elif isinstance(question, (str, os.PathLike)):
        path = Path(question)
        text = _refused(path, lambda: path.read_text(encoding="utf-8-sig"))
        folder, name = path.parent, os.fspath(question)
    else:
        raise TypeError(f"question should be a dictionary or a path, but it is `{str(question)[:60]}`")
    while (missing := _native.question_needs(text, files)) is not None:
        inner = folder / missing
        files[missing] = _refused(inner, lambda inner=inner: inner.read_text(encoding="utf-8-sig"))
    return text, files, name


@contextmanager
def _named(name: str | None) -> Iterator[None]:
    """Errors begin with the file; where there is none, they speak of no lines."""
    try:
        yield
    except ValueError as error:
        told = re.sub(r"^line \d+(, column \d+)?: ", "", str(error)) if name is None else f"{name}: {error}"
        raise ValueError(told) from None


class Table(Shown, Sequence[Mapping[str, Any]]):
    """The values of a question for every member of its family, a dictionary for each.

    Names of the family are int, Fraction or str; values are Fraction, :class:`Enclosure`, bool, or None where they
    are missing or not known. The reasons stand below the table, and in the column ``reason`` of :meth:`to_csv` and
    :meth:`to_pandas`.

    Attributes
    ----------
    names, columns : tuple of str
        The names of the family, and the quantities.
    merged : str
        The file ``merged.jsonl`` of the store: the same bytes for any number of shards, workers and interruptions.
    """

    def __init__(
        self, lines: str, csv: str, text: str, names: Sequence[str], columns: Sequence[str], merged: str
    ) -> None:
        self._rows = tuple(_row(json.loads(line), names) for line in lines.splitlines())
        self._lines, self._csv, self._shown = lines, csv, text
        self.names, self.columns, self.merged = tuple(names), tuple(columns), merged

    def __getitem__(self, index: Any) -> Any:
        return self._rows[index]

    def __len__(self) -> int:
        return len(self._rows)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Table) and self.merged == other.merged

    def __hash__(self) -> int:
        return hash(self.merged)

    def to_json_lines(self) -> str:
        """One JSON object on a line for each member."""
        return self._lines

    def to_csv(self) -> str:
        """The table as the command line writes it."""
        return self._csv

    def to_pandas(self) -> pandas.DataFrame:
        """Values as floats, the nearest to the middle, and as exact texts in ``.lo`` and ``.hi`` where they are
        enclosed somewhere.
        """
        needed("pandas", "pandas")
        import pandas

        exactly = pandas.read_csv(io.StringIO(self._csv), dtype=str, keep_default_na=False)
        frame = pandas.DataFrame(index=exactly.index)
        for name in self.names:
            frame[name] = [row[name] if isinstance(row[name], (int, str)) else str(row[name]) for row in self._rows]
        for name in self.columns:
            values = [row[name] for row in self._rows]
            truths = all(isinstance(value, bool) or value is None for value in values)
            frame[name] = values if truths else [None if v is None else float(v) for v in values]
            for end in (f"{name}.lo", f"{name}.hi"):
                if end in exactly.columns:
                    frame[end] = exactly[end]
        last = str(exactly.columns[-1])
        if last.rstrip("_") == "reason" and last not in frame.columns:
            frame[last] = exactly[last]
        return frame

    def to_parquet(self, path: str | os.PathLike[str]) -> None:
        """Writes the table of :meth:`to_pandas` as Parquet (extra ``parquet``)."""
        needed("pyarrow", "parquet")
        frame = self.to_pandas()
        # A column of one kind each: names that are numbers for some members only become texts.
        for name in self.names:
            if frame[name].map(type).nunique() > 1:
                frame[name] = frame[name].astype(str)
        frame.to_parquet(path, engine="pyarrow", index=False)

    def __repr__(self) -> str:
        return self._shown.rstrip("\n")

    def _repr_html_(self) -> str:
        names = [*self.names, *self.columns]
        more = f"<p>and {len(self) - ROWS} more rows</p>" if len(self) > ROWS else ""
        return table(names, ([str(row[name]) for name in names] for row in self._rows[:ROWS])) + more


def _row(found: dict[str, Any], names: Sequence[str]) -> dict[str, Any]:
    return {key: _name(value) if key in names else _value(value) for key, value in found.items()}


def _name(text: str) -> int | Fraction | str:
    if not re.fullmatch(r"-?\d{1,4000}(/\d{1,4000})?", text):
        return text
    number = Fraction(text)
    return int(number) if number.denominator == 1 else number


def _value(value: Any) -> Any:
    if isinstance(value, str):
        number = exact(value) if "/" in value else read_decimal(value)
        return Known(number.numerator, number.denominator)
    if isinstance(value, dict):
        return Enclosure._of((value["lo"], value["hi"])) if "lo" in value else None
    return value


@dataclass(frozen=True)
class Failure:
    """A counterexample that was made simpler.

    Attributes
    ----------
    invariant, why, instance : str
        What fails, in words, and for what.
    case : int
        Its number: the seed and it give the same case again.
    question : str or None
        A question file that :func:`check` decides alone, of questions.
    """

    invariant: str
    case: int
    why: str
    instance: str
    question: str | None


@dataclass(frozen=True)
class Invariant:
    """What a campaign found about one invariant.

    Attributes
    ----------
    id : str
    cases, undecided, failed : int
    margin : float or None
        The smallest, where there is one.
    """

    id: str
    cases: int
    undecided: int
    failed: int
    margin: float | None


@dataclass(frozen=True)
class Campaign(Shown):
    """What a campaign found; of a property that did not fail it says that no counterexample is among so many cases,
    and no more.

    Attributes
    ----------
    cases, failed, undecided : int
    invariants : tuple of Invariant
    failures : tuple of Failure
    merged : str
        The file ``merged.jsonl`` of the store: the same bytes for any number of shards, workers and interruptions.
    """

    seed: str
    cases: int
    failed: int
    undecided: int
    invariants: tuple[Invariant, ...]
    failures: tuple[Failure, ...]
    merged: str = field(repr=False)

    def __repr__(self) -> str:
        lines = [f"{self.cases} cases, seed {self.seed}: {self.failed} failed, {self.undecided} undecided"]
        for own in self.invariants:
            margin = "" if own.margin is None else f", margin {own.margin:.4e}"
            lines.append(f"  {own.id}: {own.cases} cases, {own.failed} failed, {own.undecided} undecided{margin}")
        lines += [f"  {f.invariant} fails in case {f.case}: {f.instance or f.why}" for f in self.failures]
        return "\n".join(lines)

    def _repr_html_(self) -> str:
        head, _, _ = repr(self).partition("\n")
        rows = [
            (
                own.id,
                str(own.cases),
                str(own.failed),
                str(own.undecided),
                "" if own.margin is None else f"{own.margin:.4e}",
            )
            for own in self.invariants
        ]
        failures = [f"{f.invariant} fails in case {f.case}: {f.instance or f.why}" for f in self.failures]
        return told(head) + table(("invariant", "cases", "failed", "undecided", "margin"), rows) + told("", failures)


def invariants() -> dict[str, str]:
    """The built-in invariants of :func:`fuzz`.

    Returns
    -------
    dict of str
        Statements by name.

    Examples
    --------
    >>> len(invariants()) > 10
    True
    """
    return dict(_native.invariants())


def sweep(
    question: Question,
    client: Any = None,
    *,
    define: Mapping[str, str] | None = None,
    store: str | os.PathLike[str] | None = None,
    shards: int | None = None,
    resume: bool = False,
    threads: int | None = None,
    progress: Progress = None,
) -> Table:
    """Tabulate the ``[values]`` of a question for every member of its family, or whether its property holds.

    Parameters
    ----------
    question
        The path of a question file, or the same as a dictionary.
    client
        A ``distributed.Client``: the shards are sent to its workers, which need no common file system. A worker that
        is killed costs the shard that it had; the result is byte for byte that of one process.
    define
        Names that the values may use: expressions as in ``[define]``. Functions, which :func:`check` takes too, are not
        sent to workers.
    store
        A folder for the finished shards; left out, they are kept while the table is made.
    shards
        How many; left out, 1 here, and 8 for each thread of a cluster.
    resume
        Go on with what the store has.
    threads
        For each shard; left out, all cores here, 1 on a cluster.
    progress
        Called with (stage, done, total), or True.

    Returns
    -------
    Table
        A row for each member, numbers exact or enclosed.

    Raises
    ------
    ValueError, TypeError
        What is no question; a store that holds other shards, or these already where ``resume`` is not asked for.
    OSError
        A file that cannot be read or written.

    Notes
    -----
    ``notes/questions.md`` has the language, ``notes/python.md`` how shards are sent and merged.

    Examples
    --------
    >>> table = sweep({
    ...     "question": {"id": "mine.trees"},
    ...     "for": {"n": "2..4", "graph": "trees(n)"},
    ...     "values": {"connectivity": "lambda(2)"},
    ... })
    >>> len(table), table[1]["connectivity"]
    (4, Fraction(1, 1))
    """
    kinds = "an expression, and the question a dictionary; functions are for check"
    text, files, name = _read(_defining(question, define or {}, kinds))
    plan: Plan = {"kind": "sweep", "question": text, "files": files, "invariants": [], "cases": 0, "seed": ""}
    with _named(name), _stored(store) as folder:
        _run(plan, folder, client, shards, resume, threads, progress)
        merged = _native.campaign_merge(folder)
        return Table(*_native.sweep_table(folder), merged)


def fuzz(
    question: Question | None = None,
    client: Any = None,
    *,
    invariants: str | Iterable[str] = (),
    cases: int = 1000,
    seed: str = "0",
    store: str | os.PathLike[str] | None = None,
    shards: int | None = None,
    resume: bool = False,
    threads: int | None = None,
    progress: Progress = None,
) -> Campaign:
    """Attack a question with random members of its family, or the built-in invariants with random cases;
    counterexamples are made simpler.

    Parameters
    ----------
    question
        The path of a question file, or the same as a dictionary; left out, the built-in invariants are attacked.
    invariants
        Which of them: names, or one; all where none is named.
    cases
        Random cases, of each invariant.
    seed
        Any text.
    client, store, shards, resume, threads, progress
        As for :func:`sweep`.

    Returns
    -------
    Campaign
        Counts, the smallest margin, and failures made simpler.

    Raises
    ------
    ValueError, TypeError, OSError
        As for :func:`sweep`; an invariant that is not known.

    Notes
    -----
    A campaign without a failure proves nothing; ``notes/fuzzing.md``.

    Examples
    --------
    >>> found = fuzz(cases=5, invariants=list(invariants())[0])
    >>> found.cases, found.failed
    (5, 0)
    """
    names = [invariants] if isinstance(invariants, str) else [*_texts(invariants)]
    if not isinstance(cases, int) or isinstance(cases, bool):
        raise TypeError(f"cases must be an integer, but it is `{str(cases)[:60]}`")
    if not 1 <= cases <= 2**50:
        raise ValueError(f"the number of cases should be from 1 to 2^50, not {cases}")
    if not isinstance(seed, str):
        raise TypeError(f"seed should be a text, but it is `{str(seed)[:60]}`")
    plan: Plan = {"kind": "fuzz", "question": "", "files": {}, "invariants": names, "cases": cases, "seed": seed}
    name: str | None = ""
    if question is not None:
        text, files, name = _read(question)
        plan.update(kind="attack", question=text, files=files)
    with _named(name) if question is not None else _named(None), _stored(store) as folder:
        _run(plan, folder, client, shards, resume, threads, progress)
        merged = _native.campaign_merge(folder)
        document, questions = _native.fuzz_summary(folder)
    found = json.loads(document)
    texts = {(id, case): text for id, case, text in questions}
    own = tuple(
        Invariant(i["id"], i["cases"], i["undecided"], i["failed"], _float(i["margin"])) for i in found["invariants"]
    )
    failures = tuple(
        Failure(i["id"], f["case"], f["why"], f["instance"], texts.get((i["id"], f["case"])))
        for i in found["invariants"]
        for f in i["failures"]
    )
    return Campaign(found["seed"], found["cases"], found["failed"], found["undecided"], own, failures, merged)


def _float(margin: Any) -> float | None:
    return None if margin is None else float(margin["value"].removeprefix("~"))


def _texts(names: Any) -> list[str]:
    if not hasattr(names, "__iter__"):
        raise TypeError(f"invariants should be a list of names, but it is `{str(names)[:60]}`")
    listed = list(names)
    if not all(isinstance(name, str) for name in listed):
        raise TypeError(f"invariants should be a list of names, but it is `{str(names)[:60]}`")
    return listed


@contextmanager
def _stored(store: str | os.PathLike[str] | None) -> Iterator[Path]:
    if store is not None:
        yield Path(store)
        return
    folder = Path(tempfile.mkdtemp(prefix="flockproof-"))
    try:
        yield folder
    finally:
        shutil.rmtree(folder, ignore_errors=True)


def _positive(name: str, value: Any, default: int) -> int:
    if value is None:
        return default
    if not isinstance(value, int) or isinstance(value, bool):
        raise TypeError(f"{name} must be an integer, but it is `{str(value)[:60]}`")
    if not 1 <= value <= 10**6:
        raise ValueError(f"{name} must lie between 1 and 1000000, but it is {value}")
    return value


def _run(
    plan: Plan,
    store: Path,
    client: Any,
    shards: int | None,
    resume: bool,
    threads: int | None,
    progress: Progress,
) -> None:
    told = callback(progress)
    if client is not None:
        return _on_cluster(plan, store, client, shards, resume, _positive("threads", threads, 1), told)
    threads = _positive("threads", threads, os.cpu_count() or 1)
    of = _positive("shards", shards, 1)
    for index in range(1, of + 1):
        _native.campaign_shard(plan, store, index, of, bool(resume), threads, told)
    return None


#: How often a shard is sent again after its worker died.
_TRIALS = 20


def _on_cluster(
    plan: Plan,
    store: Path,
    client: Any,
    shards: int | None,
    resume: bool,
    threads: int,
    told: Callable[[str, int, int | None], object] | None,
) -> None:
    needed("distributed", "sweep")
    import distributed

    if not isinstance(client, distributed.Client):
        raise TypeError(f"client must be a distributed.Client, but it is `{str(client)[:60]}`")
    # Its functions have no types.
    as_completed: Any = distributed.as_completed

    jobs = _native.campaign_size(plan)[1]
    workers = max(1, sum(cast(Any, client).nthreads().values()))
    of = _positive("shards", shards, max(1, min(jobs, 8 * workers)))
    store.mkdir(parents=True, exist_ok=True)
    files = {index: store / f"shard-{index}-of-{of}.jsonl" for index in range(1, of + 1)}
    there = [path for path in files.values() if path.exists()]
    if there and not resume:
        raise ValueError(f"{there[0]}: it is there already; resume=True goes on with it")
    trials = dict.fromkeys(files, 0)
    pending = {_submitted(client, plan, k, of, threads, 0): k for k, path in files.items() if not path.exists()}
    done = of - len(pending)
    waiting = as_completed(list(pending))
    try:
        for future in waiting:
            index = pending.pop(future)
            try:
                contents = future.result()
            except distributed.KilledWorker:
                trials[index] += 1
                if trials[index] >= _TRIALS:
                    raise
                again = _submitted(client, plan, index, of, threads, trials[index])
                pending[again] = index
                waiting.add(again)
                continue
            # Aside first, so that an interrupted run leaves no half shard.
            aside = files[index].with_suffix(f".{os.getpid()}-{uuid.uuid4().hex}.new")
            aside.write_bytes(cast(bytes, contents))
            aside.replace(files[index])
            done += 1
            if told is not None:
                told("shards", done, of)
    finally:
        for future in pending:
            future.cancel()


def _submitted(client: Any, plan: Plan, index: int, of: int, threads: int, trial: int) -> Any:
    return client.submit(run_shard, plan, index, of, threads, pure=False, retries=3, key=None, priority=-trial)


def run_shard(plan: Plan, index: int, of: int, threads: int) -> bytes:
    """Runs one shard on a worker; the bytes of its finished file."""
    with _stored(None) as folder:
        _native.campaign_shard(plan, folder, index, of, False, threads, None)
        return (folder / f"shard-{index}-of-{of}.jsonl").read_bytes()
