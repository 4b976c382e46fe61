"""A hundred wrong values into every public function: an answer or one sentence, never a panic."""

from __future__ import annotations

import math
from collections.abc import Callable
from decimal import Decimal
from fractions import Fraction
from pathlib import Path
from typing import Any

import networkx as nx
import numpy as np
import pandas
import pytest
import rustworkx as rx
import scipy.sparse as sp

import flockproof
from flockproof import Enclosure, ExactMatrix, claims, plot


class Odd:
    """Says that it is a number and is none."""

    numerator = "1"
    denominator = None

    def __index__(self) -> int:
        raise TypeError("no index")


class Text(str):
    pass


recursive: list[Any] = []
recursive.append(recursive)

WRONG: list[Any] = [
    None, True, False, 0, 1, -1, 2**63, -(2**63), 2**64, 10**30, -(10**30), 10**5000, 3, 7,
    0.0, -0.0, 0.5, 1.5, -1e300, 5e-324, math.nan, math.inf, -math.inf, 1j, complex("nan"),
    Decimal(1), Decimal("nan"), Decimal("-inf"), Decimal("1e-4000"), Fraction(1, 3), Fraction(-1, 10**400),
    "", " ", "x", "1/0", "0/1", "-1/2", "1e400", "1e99999", "nan", "inf", "\0", "a\0b", "é", "\ud800", Text("3"),
    "ring:",
    "ring:3", "ring:-1", "ring:99999999999999999999", "complete:99999999", "circulant:5:9", "/", ".", "no/such/file",
    "lazy", "vicsek", "paper", "D", "K", "x" * 20_000, "9" * 20_000,
    b"", b"x", bytearray(b"1"), memoryview(b"1"), (), [], {}, set(), frozenset(), [[]], [()], ((),), [None], [[None]],
    [[math.nan]], [[1, 2], [3]], [[1, 2, 3]], [["x"]], [[[1]]], [True], [[True]], [(1,)], [(1, 1)], [(1, 2, "x")],
    [(1, 2), (2, 1)], [(1, 2, math.inf)], [(1, 2, 3, 4)], [({}, 1)], [1, "x"], ["1/0"], recursive, [recursive],
    {"a": 1}, {1: 2}, {"model": 3}, {"model": "D"}, {"model": "nothing", "run": {}}, {"run": {"until": -1}},
    {"t": [1], "id": [1]},
    {"t": [1, 2], "id": [1], "x": [0], "y": [0]}, {"a": {"b": {"c": [object()]}}},
    object(), Odd(), int, len, lambda: 1, range(3), range(0), iter([]), iter([[1]]), NotImplemented, Ellipsis,
    Path("x"),
    slice(1), ValueError("x"), Path("/"),
    np.array([]), np.array(1.0), np.array([1.0, math.nan]), np.array([[math.inf]]), np.zeros((0, 0)), np.zeros((2, 3)),
    np.zeros((2, 2, 2)), np.array([[1, "a"]], dtype=object), np.array([["a"]]), np.array([[1j]]), np.eye(2,
    dtype=np.float16),
    np.array(["2020-01-01"], dtype="datetime64[D]"), np.zeros(2, dtype=[("a", int)]), np.array([[True, False]]),
    np.float32(0.1),
    np.int8(-3), np.bool_(True), np.datetime64("NaT"), np.ma.masked_array([[1.0]], [[True]]), np.array([[-1.0, 2.0],
    [0.5, 0.5]]),
    np.asfortranarray([[0.0, 1.0], [1.0, 0.0]]), np.array([[1e-300, 1e300], [1.0, 0.0]]),
    nx.Graph(), nx.path_graph(3), nx.DiGraph([(0, 1)]), nx.MultiGraph([(0, 1), (0, 1)]), nx.Graph([(0, 0)]),
    nx.Graph([(0, 1, {"weight": "x"})]), nx.Graph([(0, 1, {"weight": math.nan})]), nx.Graph([(0, 1, {"weight": None})]),
    rx.PyGraph(), rx.PyDiGraph(), rx.generators.path_graph(3), sp.eye_array(3), sp.csr_array((2, 3)),
    sp.coo_array((0, 0)),
    sp.csr_array(np.array([[1j, 0], [0, 1]])), sp.coo_array((np.array([math.nan]), (np.array([0]), np.array([1]))),
    shape=(2, 2)),
    Enclosure(1, 2), ExactMatrix(1, 1, [1]), ExactMatrix(2, 2, [0, 1, -1, 0], 3),
    pandas.DataFrame(), pandas.DataFrame({"t": [0.0], "id": ["a"], "x": [math.nan], "y": [0.0]}), pandas.Series([1]),
]  # fmt: skip


POSITIONS, VELOCITIES = [[0], [1]], [[1], [0]]
SCENARIO: dict[str, Any] = {
    "model": "phase",
    "graph": {"kind": "complete"},
    "state": {"phases": ["0", "1"]},
    "law": {"K1": -1},
    "run": {"until": 1, "samples": [1]},
}
FLOCK = flockproof.Flock(POSITIONS, VELOCITIES)
QUESTION: dict[str, Any] = {
    "question": {"id": "wrong.value", "statement": "Two."},
    "for": {"n": "2..3", "graph": "trees(n)"},
    "holds": {"property": "lambda(2) >= 1/2", "controls": ["lambda(2) >= 2"]},
}
VALUES: dict[str, Any] = {"question": {"id": "wrong.value"}, "for": {"n": "2..3"}, "values": {"n": "n"}}


def question_with(section: str, key: str) -> Callable[[Any], Any]:
    return lambda wrong: flockproof.check({**QUESTION, section: {**QUESTION[section], key: wrong}})


def scenario_with(section: str, key: str) -> Callable[[Any], Any]:
    def run(wrong: Any) -> Any:
        # A number of 30 digits is right, and too stiff for a test.
        if isinstance(wrong, (int, float, Fraction)) and abs(wrong) > 1000:
            return None
        return flockproof.simulate({**SCENARIO, section: {**SCENARIO[section], key: wrong}})

    return run


CALLS: dict[str, Callable[[Any], Any]] = {
    "exact": flockproof.exact,
    "Enclosure.lo": Enclosure,
    "Enclosure.hi": lambda x: Enclosure(-1, x),
    "Enclosure.in": lambda x: x in Enclosure(0, 1),
    "Enclosure +": lambda x: Enclosure(0, 1) + x,
    "Enclosure /": lambda x: Enclosure(0, 1) / x,
    "Enclosure **": lambda x: Enclosure(0, 1) ** x if not is_large(abs(x) if isinstance(x, int) else x) else None,
    "Enclosure <": lambda x: Enclosure(0, 1) < x,
    "Enclosure ==": lambda x: bool(np.all(Enclosure(0, 1) == x)),
    "resonance.followers": lambda x: flockproof.resonance(x, -1, -1),
    "resonance.f": lambda x: flockproof.resonance(3, x, -1),
    "resonance.g": lambda x: flockproof.resonance(3, -1, x),
    "resonance.digits": lambda x: flockproof.resonance(3, -1, -1, x),
    "spectrum.graph": flockproof.spectrum,
    "spectrum.kind": lambda x: flockproof.spectrum("ring:3", x),
    "spectrum.digits": lambda x: flockproof.spectrum("ring:3", digits=x),
    "spectrum.root": lambda x: flockproof.spectrum("ring:3", "reduced", root=x),
    "spectrum.root of a graph": lambda x: flockproof.spectrum([(1, 2), (2, 3)], "reduced", root=x),
    "spectrum.directed": lambda x: flockproof.spectrum(x, "normalised"),
    "spectrum.zero_based": lambda x: flockproof.spectrum(x, zero_based=True),
    "reach": flockproof.reach,
    "ergodicity": flockproof.ergodicity,
    "ergodicity.normalised": lambda x: flockproof.ergodicity([x], normalise=True),
    "ergodicity.normalised entry": lambda x: flockproof.ergodicity([[[x, 1], [0, 1]]], normalise=True),
    "ergodicity.matrix": lambda x: flockproof.ergodicity([x]),
    "ergodicity.entry": lambda x: flockproof.ergodicity([[[x, 0], [0, 1]]]),
    "ergodicity.progress": lambda x: flockproof.ergodicity([[[1]]], progress=x),
    "Flock.positions": lambda x: flockproof.Flock(x, VELOCITIES),
    "Flock.position": lambda x: flockproof.Flock([[x], [1]], VELOCITIES),
    "Flock.velocities": lambda x: flockproof.Flock(POSITIONS, x),
    "Flock.model": lambda x: flockproof.Flock(POSITIONS, VELOCITIES, x),
    "Flock.weights": lambda x: flockproof.Flock(POSITIONS, VELOCITIES, weights=x),
    "Flock.hysteresis": lambda x: flockproof.Flock(POSITIONS, VELOCITIES, hysteresis=x),
    "Flock.control": lambda x: flockproof.Flock(POSITIONS, VELOCITIES, control=x),
    "Flock.speed": lambda x: flockproof.Flock([[0, 0], [1, 1]], model="K", speed=x, headings=[0, 1]),
    "Flock.headings": lambda x: flockproof.Flock([[0, 0], [1, 1]], model="K", speed=1, headings=x),
    "Flock.kappa": lambda x: flockproof.Flock([[0, 0], [1, 1]], model="K", speed=1, headings=[0, 1], kappa=x),
    "Flock.ids": lambda x: flockproof.Flock(POSITIONS, VELOCITIES, ids=x),
    "Flock.from_json": flockproof.Flock.from_json,
    "Flock.from_file": flockproof.Flock.from_file,
    "Flock.run.until": lambda x: FLOCK.run(x) if not is_large(x) else None,
    "Flock.run.from_": lambda x: FLOCK.run(3, from_=x, products=True),
    "Flock.settle.steps": lambda x: FLOCK.settle(steps=x),
    "Flock.settle.switches": lambda x: FLOCK.settle(switches=x),
    "simulate": flockproof.simulate,
    "simulate.member": lambda x: flockproof.simulate(SCENARIO, member=x),
    "simulate.member of many": lambda x: flockproof.simulate({**SCENARIO, "sweep": {"law.K1": [-1, 1]}}, member=x),
    "simulate.model": lambda x: flockproof.simulate({**SCENARIO, "model": x}),
    "simulate.graph": scenario_with("graph", "kind"),
    "simulate.state": scenario_with("state", "phases"),
    "simulate.law": scenario_with("law", "K1"),
    "simulate.samples": scenario_with("run", "samples"),
    "simulate.tolerance": scenario_with("run", "tolerance"),
    "tracks": flockproof.tracks,
    "tracks.window": lambda x: flockproof.tracks(TRACKS, null=0, window=x),
    "tracks.zones": lambda x: flockproof.tracks(TRACKS, null=0, zones=x),
    "tracks.blind": lambda x: flockproof.tracks(TRACKS, null=0, blind=x),
    "tracks.nearest": lambda x: flockproof.tracks(TRACKS, null=0, nearest=x),
    "tracks.ids": lambda x: flockproof.tracks(TRACKS, null=0, ids=x),
    "tracks.seed": lambda x: flockproof.tracks(TRACKS, null=0, seed=x),
    "tracks.null": lambda x: flockproof.tracks(TRACKS, null=x) if not is_large(x) else None,
    "check": flockproof.check,
    "check.question": lambda x: flockproof.check({**QUESTION, "question": x}),
    "check.id": question_with("question", "id"),
    "check.kind": question_with("question", "kind"),
    "check.family": question_with("for", "n"),
    "check.graph": question_with("for", "graph"),
    "check.property": question_with("holds", "property"),
    "check.controls": question_with("holds", "controls"),
    "check.progress": lambda x: flockproof.check(QUESTION, progress=x),
    "sweep": flockproof.sweep,
    "sweep.values": lambda x: flockproof.sweep({**VALUES, "values": x}),
    "sweep.client": lambda x: flockproof.sweep(VALUES, x),
    "sweep.shards": lambda x: flockproof.sweep(VALUES, shards=x),
    "sweep.threads": lambda x: flockproof.sweep(VALUES, threads=x),
    "fuzz": lambda x: flockproof.fuzz(x, cases=1) if x is not None else None,
    "fuzz.invariants": lambda x: flockproof.fuzz(invariants=x, cases=1) if not is_empty(x) else None,
    "fuzz.cases": lambda x: flockproof.fuzz(QUESTION, cases=x) if not is_large(x) else None,
    "fuzz.seed": lambda x: flockproof.fuzz(QUESTION, cases=1, seed=x),
    "fuzz.shards": lambda x: flockproof.fuzz(QUESTION, cases=1, shards=x),
    "verify.papers": lambda x: flockproof.verify(papers=x, claims=NOTHING) if not is_empty(x) else None,
    "verify.claims": lambda x: flockproof.verify(claims=x) if not is_empty(x) else None,
    "verify.seed": lambda x: flockproof.verify(claims=NOTHING, seed=x),
    "verify.threads": lambda x: flockproof.verify(claims=NOTHING, threads=x),
    "explain": flockproof.explain,
    "Claims": flockproof.Claims,
    "claim.id": lambda x: claims.claim(x, "s", printed=1, controls={"c": 2}),
    "claim.statement": lambda x: claims.claim("mine.a", x, printed=1, controls={"c": 2}),
    "claim.controls": lambda x: claims.claim("mine.a", "s", printed=1, controls=x)(undecided),
    "claim.clauses": lambda x: claims.claim("mine.a", "s", printed=1, controls={"c": 2}, clauses=x)(undecided),
    "claim.repaired": lambda x: claims.claim("mine.a", "s", printed=1, controls={"c": 2}, repaired=x)(undecided),
    "claim.expected": lambda x: claims.claim("mine.a", "s", printed=1, controls={"c": 2}, expected=x)(undecided),
    "claims.verify": claims.verify,
    "claims.every": claims.every,
    "claims.some": claims.some,
    "plot.paths": plot.paths,
    "plot.observables": plot.observables,
    "plot.resonances": lambda x: plot.resonances(x) if not is_empty(x) else None,
    "plot.spectrum": plot.spectrum,
    "plot.network": plot.network,
    "plot.settlement": plot.settlement,
    "plot.circle": plot.circle,
    "plot.portrait": plot.portrait,
    "plot.tracks": plot.tracks,
    "plot.sweep": lambda x: plot.sweep(x, "n", "value"),
    "ledger[]": lambda x: flockproof.ledger()[x] if isinstance(x, str) else None,
    "ledger.paper": lambda x: flockproof.ledger().paper(x),
}


def undecided(variant: Any, run: claims.Run) -> claims.Outcome:
    return run.undecided("nobody knows")


#: Quick to check.
NOTHING = next(claim.id for claim in flockproof.ledger() if claim.verdict == "not_checkable")

TRACKS = {
    "t": [t / 10 for t in range(60) for _ in range(3)],
    "id": [name for _ in range(60) for name in "abc"],
    "x": [float(t + k * 3) for t in range(60) for k in range(3)],
    "y": [float((t * k) % 7) for t in range(60) for k in range(3)],
}


def is_large(x: Any) -> bool:
    """Right, and takes too long for a test."""
    return isinstance(x, int) and x > 1000 and x < 2**64


def is_empty(x: Any) -> bool:
    """All claims are meant."""
    return (hasattr(x, "__len__") and len(x) == 0) or type(x).__name__ == "list_iterator"


def test_there_are_a_hundred() -> None:
    assert len(WRONG) >= 100


@pytest.mark.filterwarnings("ignore")
@pytest.mark.parametrize("name", CALLS)
def test_wrong_values(name: str) -> None:
    for wrong in WRONG:
        try:
            CALLS[name](wrong)
        except (ValueError, TypeError, OSError, ZeroDivisionError) as error:
            assert str(error) and "internal error" not in str(error)
        except BaseException as error:
            pytest.fail(f"{name}({type(wrong).__name__} {str(wrong)[:60]!r}): {type(error).__name__}: {error}")


@pytest.mark.parametrize("graph", [
    [(1, 2), (2, 3), (2, 1)],
    nx.MultiGraph([(0, 1), (0, 1)]),
    nx.MultiDiGraph([(0, 1), (0, 1)]),
])  # fmt: skip
def test_an_edge_is_listed_once(graph: Any) -> None:
    with pytest.raises(ValueError, match="is given twice, as number 1 and number"):
        flockproof.spectrum(graph)
