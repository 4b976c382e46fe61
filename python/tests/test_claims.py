"""Claims of one's own: judged by the ledger's rules, and grades that cannot be overstated."""

from __future__ import annotations

import json
import math
from fractions import Fraction
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from conftest import ASSETS, command_line
from hypothesis import given
from hypothesis import strategies as st

import flockproof
from flockproof.claims import Claimed, Exact, Run, Truth, claim, every, some, verify

fractions = st.fractions(max_denominator=1000)


def simple(check: Any, printed: Any = True, controls: dict[str, Any] | None = None, **more: Any) -> Claimed[Any]:
    """A claim whose controls are refuted whatever the check is."""
    return claim(
        "mine.one",
        "A statement.",
        printed=printed,
        controls={"altered": False} if controls is None else controls,
        **more,
    )(check)


def graded(holds: Any) -> tuple[str, ...]:
    """The grades of a check that looks at one case."""

    def check(variant: bool, run: Run) -> Any:
        return run.instances("part", "detail", [1], lambda case: holds(case) if variant else Exact(0) == 1)

    entry = simple(check).verify()
    assert entry.verdict == "holds", entry
    grades: tuple[str, ...] = entry.grades
    return grades


def test_a_claim_that_holds() -> None:
    def check(variant: bool, run: Run) -> Any:
        "Why it is true."
        run.value("a third", Exact(1, 3))
        run.value("measured", 0.5)
        return run.exhaustive("part", "detail", range(3), lambda n: Exact(n) < (3 if variant else 2))

    report = verify(simple(check, expected="holds", expected_grades=["exhaustive"]))
    entry = report["mine.one"]
    assert report.as_recorded, report.differences
    assert entry.verdict == "holds" and entry.evidence[0].cases == 3 and entry.evidence[0].scope == "all"
    assert entry.values == {"a third": "1/3", "measured": "~0.5"}
    assert entry.controls.failed == ("part: 2: 2 < 2 does not hold",)
    document = json.loads(report.to_json())
    assert document["schema"] == "flockproof.ledger/2" and document["claims"][0]["id"] == "mine.one"
    assert "Why it is true." in entry.derivation and "mine.one" in repr(report)


def test_a_false_statement_with_its_correction() -> None:
    def check(least: int, run: Run) -> Any:
        return run.instances("n from the least on", "compared", range(least, 9), lambda n: Exact(n) ** 2 > n)

    one = claim(
        "mine.squares", "n^2 > n.", printed=0, controls={"from 1": 1}, repaired=("hypothesis", "n^2 > n for n > 1.", 2)
    )(check)
    report = verify(one)
    assert (
        report["mine.squares"].verdict == "needs_hypothesis"
        and report["mine.squares"].corrected == "n^2 > n for n > 1."
    )
    assert report["mine.squares"].counterexample == "n from the least on: 0: 0 > 0 does not hold"
    assert report["beyond.mine.squares"].verdict == "holds" and report.as_recorded


def test_rules_of_the_ledger_hold_for_own_claims() -> None:
    def check(variant: bool, run: Run) -> Any:
        return run.instances("part", "detail", [1], lambda n: Exact(n) == 1)

    assert "a negative control was not refuted: altered: it holds" in str(verify(simple(check)).differences)
    assert "there is no negative control" in str(verify(simple(check, controls={})).differences)
    assert "recorded false, reached holds" in str(verify(simple(check, expected="false")).differences)

    def empty(variant: bool, run: Run) -> Any:
        return run.instances("part", "detail", [], lambda n: True)

    assert simple(empty).verify().verdict == "undecided"

    def two(variant: bool, run: Run) -> Any:
        return run.instances("part", "detail", [1], lambda n: Exact(n) == (1 if variant else 2), clauses=[1])

    assert "clause 2 is not covered" in str(verify(simple(two, clauses=["one", "two"])).differences)


def test_grades_follow_from_what_went_in() -> None:
    assert graded(lambda n: Exact("0.1") * 3 == Exact("0.3")) == ("exact",)
    assert graded(lambda n: Exact(2).sqrt() > Exact("1.4")) == ("certified",)
    assert graded(lambda n: Exact(flockproof.resonance(9, -1, -1).amplitude) > 1) == ("certified",)
    assert graded(lambda n: Exact(flockproof.ergodicity([[["1/2", "1/2"]] * 2]).tau_1) == 0) == ("exact",)
    assert graded(lambda n: every(Exact(k) < 5 for k in range(4)) & ~some(Exact(k) > 5 for k in range(4))) == ("exact",)


LEAKS: dict[str, Any] = {
    "a float": lambda n: Exact(0.5) < 1,
    "a float on the right": lambda n: Exact(n) < 1.5,
    "a float of numpy": lambda n: Exact(n) + np.float64(1) == 2,
    "math": lambda n: Exact(math.sqrt(2)) < 2,
    "a plain bool": lambda n: 0.1 + 0.2 > 0.3,
    "a bool of numpy": lambda n: np.float64(1) < 2,
    "a fraction of a float": lambda n: Exact(Fraction(0.1)) < 1,
    "an enclosure of a float": lambda n: Exact(flockproof.Enclosure(0.1)) < 1,
    "an enclosure of a fraction of a float": lambda n: Exact(flockproof.Enclosure(Fraction(0.1))) < 1,
    "a sum with a float": lambda n: Exact(flockproof.Enclosure(1) + 0.1) < 2,
    "a branch on a float": lambda n: Exact(0) == 0 if Exact(0.5) < 1 else Exact(1) == 0,
    "an exact number made a float": lambda n: Exact(int(float(Exact(7, 2)))) == 3,
    "an integer of a marked number": lambda n: Exact(int(Exact(3.5))) == 3,
    "a resonance of floats": lambda n: Exact(flockproof.resonance(4, -1.0, -1).amplitude) > 1,
    "a spectrum of floats": lambda n: Exact(flockproof.spectrum(np.array([[0, 0.5], [0.5, 0]]))[0].exact) == 0,
    "the length of a spectrum of floats": lambda n: (
        Exact(len(flockproof.spectrum(np.array([[0, 0.5], [0.5, 0]])))) == 2
    ),
    "a product of floats": lambda n: Exact(flockproof.ergodicity([np.full((2, 2), 0.5)]).product[0, 0]) > 0,
    "a flock of floats": lambda n: Exact(len(flockproof.Flock([0.0, 3.0], [0.0, 0.0]).settle().flocks)) == 2,
    "a simulation": lambda n: (
        Exact(int(flockproof.simulate(ASSETS / "scenarios" / "three_agents.toml").t[-1] * 0)) == 0
    ),
    "arithmetic with results": lambda n: Exact(flockproof.ergodicity([[["1/2", "1/2"]] * 2]).tau_1 + Fraction(0.5)) > 0,
}


@pytest.mark.parametrize("name", LEAKS)
def test_what_passed_through_a_float_is_at_most_simulated(name: str) -> None:
    assert graded(LEAKS[name]) == ("simulated",)


def test_a_float_anywhere_before_marks_what_follows() -> None:
    def check(variant: bool, run: Run) -> Any:
        count = len(flockproof.Flock([0.0, 3.0], [0.0, 0.0]).settle().flocks)
        return run.exhaustive("part", "detail", [count], lambda n: Exact(n) == (2 if variant else 3))

    entry = simple(check).verify()
    assert (
        entry.grades == ("simulated",)
        and entry.evidence[0].scope == "instances"
        and "float" in entry.evidence[0].detail
    )


def test_floats_do_not_condemn_a_statement() -> None:
    def check(variant: bool, run: Run) -> Any:
        return run.instances("part", "detail", [1], lambda n: Exact(0.1) * 3 == Exact(0.3))

    entry = simple(check).verify()
    assert entry.verdict == "undecided" and entry.why is not None and "suggests a counterexample" in entry.why
    assert entry.controls.refuted == 1


def test_outcomes_are_made_by_the_run() -> None:
    from flockproof.claims import Outcome

    for fake in (Outcome("holds", "", ()), None, True, {"outcome": "holds"}):
        entry = simple(lambda variant, run, fake=fake: fake).verify()
        assert entry.verdict == "undecided" and "returns what a method of its run returned" in str(entry.why)
    stolen: list[Any] = []

    def check(variant: bool, run: Run) -> Any:
        stolen.append(run.argued("part", "nowhere"))
        return stolen[0]

    assert simple(check).verify().controls.refuted == 0


def test_errors_and_wide_enclosures_are_undecided() -> None:
    assert "ZeroDivisionError" in str(simple(lambda v, run: 1 / 0).verify().why)
    wide = Exact(flockproof.Enclosure(0, 2))

    def check(variant: bool, run: Run) -> Any:
        return run.instances("part", "detail", [1], lambda n: wide < 1)

    assert "too wide" in str(simple(check).verify().why)
    branch = simple(lambda v, run: run.instances("part", "detail", [1], lambda n: (wide < 1) or True))
    assert "too wide" in str(branch.verify().why)

    def bad(variant: bool, run: Run) -> Any:
        return run.instances("part", "detail", [1], lambda n: None)

    assert "a comparison is expected" in str(simple(bad).verify().why)


def test_ctrl_c_is_not_swallowed() -> None:
    def check(variant: bool, run: Run) -> Any:
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        simple(check).verify()


def test_random_cases_depend_on_seed_and_id_only() -> None:
    def check(variant: bool, run: Run) -> Any:
        run.value("drawn", run.random().randrange(10**9))
        return run.fuzzed(
            "part", "detail", 20, lambda r: r.randrange(100), lambda n: Exact(n) < (100 if variant else 50)
        )

    one, two = simple(check).verify(), simple(check).verify()
    assert one.values == two.values and one.grades == ("fuzzed",) and one == two
    assert simple(check).verify(seed="other").values != one.values


@pytest.mark.parametrize("wrong", ["", "x", "X.y", "veerman.mine", "beyond.mine", "a b.c", 3, None])
def test_ids_are_refused(wrong: Any) -> None:
    with pytest.raises(ValueError):
        claim(wrong, "A statement.", printed=1, controls={})
    with pytest.raises(ValueError):
        claim("mine.x", "A statement.", printed=1, controls={}, repaired=("nothing", "x", 1))
    with pytest.raises(TypeError):
        verify("mine.x")  # type: ignore[arg-type]


def test_twice_the_same_id() -> None:
    one = simple(lambda variant, run: run.undecided("x"))
    with pytest.raises(ValueError, match="registered twice"):
        verify(one, one)


def test_export(tmp_path: Path) -> None:
    report = verify(simple(lambda variant, run: run.undecided("nobody knows")))
    report.save(tmp_path / "ledger.json")
    assert json.loads((tmp_path / "ledger.json").read_text())["claims"][0]["why"] == "nobody knows"
    assert "mine.one" in report._repr_html_()
    command_line("report", "--ledger", str(tmp_path / "ledger.json"), "--no-figures", "--out", str(tmp_path / "site"))
    page = (tmp_path / "site/claims/mine.one.html").read_text()
    assert (
        "A statement." in page and "nobody knows" in page and "mine.one" in (tmp_path / "site/index.html").read_text()
    )


@given(fractions, fractions)
def test_exact_numbers_compute_as_fractions(a: Fraction, b: Fraction) -> None:
    x, y = Exact(str(a)), Exact(str(b))
    for mine, theirs in [
        (x + y, a + b),
        (x - y, a - b),
        (x * y, a * b),
        (-x, -a),
        (abs(x), abs(a)),
        (x**2, a**2),
        (1 - x, 1 - a),
    ]:
        assert mine.lo == mine.hi == theirs and mine.is_exact
    if b:
        assert (x / y).lo == a / b and (x**2 / y**2 == (y / x) ** -2 if a else True)
    for mine, expected in [
        (x < y, a < b),
        (x <= y, a <= b),
        (x > y, a > b),
        (x >= y, a >= b),
        (x == y, a == b),
        (x != y, a != b),
    ]:
        assert isinstance(mine, Truth) and mine.value == expected and mine.grade == "exact"
    if a >= 0:
        root = x.sqrt(10)
        assert root.lo**2 <= a <= root.hi**2 and root.hi - root.lo <= Fraction(1, 10**9)


@given(fractions, st.fractions(0, 1, max_denominator=50))
def test_enclosed_numbers_enclose(a: Fraction, width: Fraction) -> None:
    x = Exact(flockproof.Enclosure(str(a), str(a + width)))
    for t in (a, a + width / 3, a + width):
        for mine, theirs in [
            (x * x, t * t),
            (x**2, t**2),
            (abs(x), abs(t)),
            (x - 3, t - 3),
            (2 * x, 2 * t),
            (x**3, t**3),
        ]:
            assert mine.lo <= theirs <= mine.hi
