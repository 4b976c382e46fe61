"""Conversions: exact in, exact or enclosed out."""

from __future__ import annotations

import copy
import pickle
from decimal import Decimal
from fractions import Fraction
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import flockproof
from flockproof import Enclosure, ExactMatrix, Undecided, exact
from flockproof._numbers import exact_matrix, integer_text, over_common_denominator

fractions = st.fractions(max_denominator=10**6)


@given(fractions)
def test_every_way_to_write_a_number_is_exact(x: Fraction) -> None:
    assert exact(x) == x == exact(str(x)) == exact(f" {x} ")
    assert exact(x.numerator) == x.numerator


@given(st.decimals(allow_nan=False, allow_infinity=False, places=6))
def test_decimals_are_exact(x: Decimal) -> None:
    assert exact(x) == Fraction(x) == exact(str(x))


@given(st.floats(allow_nan=False, allow_infinity=False))
def test_a_float_is_the_exact_value_of_the_double(x: float) -> None:
    assert exact(x) == Fraction(x) == exact(np.float64(x))


@given(st.integers(min_value=-(2**70), max_value=2**70))
def test_integers_of_any_length(x: int) -> None:
    assert exact(x) == x
    if -(2**63) <= x < 2**63:
        assert exact(np.int64(x)) == x


@pytest.mark.parametrize(
    "wrong",
    ["", "1/0", "x", "1e99999", float("nan"), float("inf"), Decimal("nan"), Decimal("inf"), 10**10001, np.nan],
    ids=range(10),
)
def test_what_is_no_number_is_a_value_error(wrong: Any) -> None:
    with pytest.raises(ValueError, match="f: "):
        exact(wrong, "f")


@pytest.mark.parametrize("wrong", [None, True, [1], {}, b"1", object(), 1j, np.array([1.0])])
def test_what_is_of_another_kind_is_a_type_error(wrong: Any) -> None:
    with pytest.raises((TypeError, ValueError)):
        exact(wrong, "f")


@given(fractions, fractions)
def test_an_enclosure_is_what_it_says(a: Fraction, b: Fraction) -> None:
    lo, hi = min(a, b), max(a, b)
    x = Enclosure(lo, hi)
    assert (x.lo, x.hi, x.mid, x.radius) == (lo, hi, (lo + hi) / 2, (hi - lo) / 2)
    assert lo in x and hi in x and x.mid in x and hi + 1 not in x
    assert float(x) == float(x.mid)
    for twin in (pickle.loads(pickle.dumps(x)), copy.copy(x), copy.deepcopy(x), eval(repr(x))):
        assert twin == x and hash(twin) == hash(x) and str(twin) == str(x)


@given(fractions, fractions, fractions, fractions)
def test_arithmetic_of_enclosures_encloses(a: Fraction, b: Fraction, c: Fraction, d: Fraction) -> None:
    x, y = Enclosure(min(a, b), max(a, b)), Enclosure(min(c, d), max(c, d))
    assert a + c in x + y and b - d in x - y and a * d in x * y and -b in -x
    assert a + 1 in x + 1 and 2 * a in 2 * x and 1 - a in 1 - x
    if 0 not in y:
        assert a / c in x / y


def test_numbers_longer_than_python_prints() -> None:
    n = 7**9001
    x = Enclosure._of((integer_text(n), integer_text(n + 1) + "e3"))
    assert (x.lo, x.hi) == (n, (n + 1) * 1000) and pickle.loads(pickle.dumps(x)) == x
    y = Enclosure._of(("-1." + "3" * 5000, "-1." + "2" * 5000 + "e-7"))
    assert y.lo == -(1 + Fraction(int("3" * 4000) * 10**1000 + int("3" * 1000), 10**5000)) and y.lo < y.hi < 0
    assert flockproof.resonance(7, -1, -1, digits=5000).frequency.radius < Fraction(1, 10**4999)


def test_comparisons_are_certain_or_refused() -> None:
    x = Enclosure(1, 2)
    assert x < 3 and x > 0 and x <= 2 and x >= 1 and not x > 2 and not x < 1
    with pytest.raises(Undecided):
        assert x < Fraction(3, 2)
    with pytest.raises(ZeroDivisionError):
        assert 1 / Enclosure(-1, 1)
    with pytest.raises(ValueError, match="lies above"):
        Enclosure(2, 1)
    with pytest.raises(TypeError):
        assert x < object()  # type: ignore[operator]


def test_floats_leave_a_mark() -> None:
    assert not Enclosure(1, 2).from_floats
    assert Enclosure(0.5).from_floats and (Enclosure(1) + 0.5).from_floats


@given(st.lists(st.floats(allow_nan=False, allow_infinity=False, allow_subnormal=True), min_size=1, max_size=8))
def test_arrays_of_floats_cross_exactly(values: list[float]) -> None:
    integers, denominator = over_common_denominator(np.array(values), "x")
    assert [Fraction(x, denominator) for x in integers] == [Fraction(x) for x in values]


@given(st.lists(st.one_of(st.integers(), fractions), min_size=1, max_size=8))
def test_lists_cross_exactly(values: list[Any]) -> None:
    integers, denominator = over_common_denominator(values, "x")
    assert [Fraction(x, denominator) for x in integers] == values


def test_matrices() -> None:
    m = exact_matrix([["1/2", Fraction(1, 3)], [1, Decimal("0.25")]], "m")
    assert m[0, 1] == Fraction(1, 3) and m[1] == (1, Fraction(1, 4)) and m.shape == (2, 2)
    assert pickle.loads(pickle.dumps(m)) == m == copy.deepcopy(m) and hash(m) == hash(exact_matrix(m.tolist(), "m"))
    assert np.asarray(m).dtype == np.float64 and np.asarray(m)[1, 1] == 0.25
    for order in ("C", "F"):
        assert exact_matrix(np.asarray(m, order=order), "m")[1, 1] == Fraction(1, 4)  # type: ignore[call-overload]
    with pytest.raises(ValueError, match="row 2 has 1 entries where row 1 has 2"):
        exact_matrix([[1, 2], [3]], "m")
    with pytest.raises(ValueError, match="not a number"):
        exact_matrix(np.array([[np.nan]]), "m")
    with pytest.raises(ValueError, match="fill"):
        ExactMatrix(2, 2, [1], 1)


@given(fractions, fractions, fractions, st.integers(-3, 4))
def test_powers_and_absolute_values_are_enclosed(a: Fraction, b: Fraction, t: Fraction, n: int) -> None:
    x = Enclosure(min(a, b), max(a, b))
    inside = x.lo + (x.hi - x.lo) * (t - t.__floor__())
    assert abs(inside) in abs(x) and abs(x).lo >= 0
    if n >= 0 or 0 not in x:
        assert inside**n in x**n
        assert n == 0 or {(x**n).lo, (x**n).hi} <= {x.lo**n, x.hi**n, Fraction(0)}
    else:
        with pytest.raises(ZeroDivisionError):
            x**n
    if 0 not in x:
        assert bool(x)
    elif x.lo == x.hi:
        assert not x
    else:
        with pytest.raises(Undecided):
            bool(x)
