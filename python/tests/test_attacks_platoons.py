"""Attacks on the results about platoons, in floating point and from the equations of motion."""

from __future__ import annotations

import math
import random

import numpy as np
import pytest
from attacks import words

# y_k is how far follower k is from its place: y_k'' = f (y_k - m_k) + g (y_k' - m_k'), m_k that of what k tracks.


def motion(m: int, f: float, g: float) -> np.ndarray:
    """The matrix of system (2) behind a leader at rest, for positions and then velocities."""
    p = np.eye(m)
    for k in range(m):
        tracked = [k - 1, k + 1] if k + 1 < m else [k - 1]
        for j in tracked:
            if j >= 0:
                p[k, j] -= 1 / len(tracked)
    return np.block([[np.zeros((m, m)), np.eye(m)], [f * p, g * p]])


def last_amplitude(m: int, f: float, g: float, w: float) -> float:
    """|y_M| of system (2), leader e^{iwt}, by elimination, gamma y_M = y_{M-1}, 2 gamma y_k = y_{k-1} + y_{k+1}."""
    gamma = 1 + w * w / complex(f, w * g)
    quotient = 1 / gamma
    product = quotient
    for _ in range(m - 1):
        quotient = 1 / (2 * gamma - quotient)
        product *= quotient
    return abs(product)


def slope(m: int, f: float, g: float, w: float) -> float:
    """d log |y_M|/dw from y_M = 1/cosh(M z), cosh z = gamma."""
    gamma = 1 + w * w / complex(f, w * g)
    rate = 2 * w / complex(f, w * g) - w * w * complex(0, g) / complex(f, w * g) ** 2
    z = np.arccosh(gamma)
    return float((-m * np.tanh(m * z) * rate / np.sinh(z)).real)


def gains(choose: random.Random) -> tuple[float, float]:
    return -math.exp(choose.uniform(-4, 4)), -math.exp(choose.uniform(-4, 4))


def test_the_closed_form_is_the_response() -> None:
    for case in range(40):
        choose = random.Random(case)
        f, g = gains(choose)
        m, w = choose.randint(1, 9), math.exp(choose.uniform(-4, 2)) * math.sqrt(-f)
        right = np.zeros(2 * m, complex)
        right[m] = -complex(f, w * g) * (0.5 if m > 1 else 1)
        amplitude = abs(np.linalg.solve(1j * w * np.eye(2 * m) - motion(m, f, g), right)[m - 1])
        assert amplitude == pytest.approx(last_amplitude(m, f, g, w), rel=1e-8)
        step = 1e-6 * w
        quotient = math.log(last_amplitude(m, f, g, w + step) / last_amplitude(m, f, g, w - step)) / (2 * step)
        assert quotient == pytest.approx(slope(m, f, g, w), rel=1e-4, abs=1e-4 / w)


def main_resonance(m: int, f: float, g: float) -> float:
    """The largest of all local maxima on a dense grid, then the zero of the slope beside it."""
    grid = math.sqrt(-f) * np.geomspace(1e-3 / m, 50, 6000)
    at = int(np.argmax([last_amplitude(m, f, g, w) for w in grid]))
    low, high = float(grid[max(at - 1, 0)]), float(grid[at + 1])
    assert slope(m, f, g, low) > 0 > slope(m, f, g, high)
    for _ in range(200):
        middle = (low + high) / 2
        low, high = (middle, high) if slope(m, f, g, middle) > 0 else (low, middle)
    return (low + high) / 2


@pytest.mark.parametrize("case", range(60))
def test_the_next_order_of_the_resonance(case: int) -> None:
    words(
        "beyond.veerman.resonance_frequency",
        "M = N + 1 >= 5 max(1, b)",
        "(1 - q^2 (1/12 + b^2/8) + e)",
        "|e| <= 1.7 (q max(1, b))^4",
    )
    words(
        "beyond.veerman.resonance_amplitude",
        "A_0 (1 - q^2 (1/12 - 3 b^2/8 + pi^2 b^2/96) + e)",
        "A_0 = 8 sqrt(2) M/(pi^2 b)",
        "|e| <= 11 (q max(1, b))^4",
    )
    choose = random.Random(case)
    f, g = gains(choose)
    b = -g / math.sqrt(-f)
    if b > 8:
        f, b = f * b * b / 4, 2.0
    m = math.ceil(5 * max(1, b)) + choose.choice([0, 0, 1, 3, 20])
    w = main_resonance(m, f, g)
    q = math.pi / (2 * math.sqrt(2) * m)
    size = (q * max(1, b)) ** 4
    assert abs(w / (math.sqrt(-f) * q) - (1 - q * q * (1 / 12 + b * b / 8))) <= 1.7 * size + 1e-9
    first = 8 * math.sqrt(2) * m / (math.pi**2 * b)
    correction = 1 - q * q * (1 / 12 - 3 * b * b / 8 + math.pi**2 * b * b / 96)
    assert abs(last_amplitude(m, f, g, w) / first - correction) <= 11 * size + 1e-9


@pytest.mark.parametrize("case", range(60))
def test_the_slowest_rate(case: int) -> None:
    words(
        "beyond.veerman.decay_rate",
        "M = N + 1 >= |g|/sqrt|f|",
        "exactly |g| (1 - cos(pi/(2M)))/2",
        "less than pi^2 |g|/(16 M^2)",
    )
    choose = random.Random(case)
    f, g = gains(choose)
    least = -g / math.sqrt(-f)
    m = choose.randint(1, 30)
    if m < least:
        f = -((g / m) ** 2) * choose.choice([1.0001, 2, 10])
    rate = -g * (1 - math.cos(math.pi / (2 * m))) / 2
    values = np.linalg.eigvals(motion(m, f, g))
    assert -values.real.max() == pytest.approx(rate, rel=1e-5, abs=1e-9 * abs(values).max())
    assert rate < math.pi**2 * -g / (16 * m * m)


@pytest.mark.parametrize("case", range(40))
def test_where_the_gain_of_one_car_is_largest(case: int) -> None:
    words("beyond.veerman.gain_max", "w^2 = (f^2/g^2) (sqrt(1 + 2 g^2/|f|) - 1)", "and only then", "less than |f|")
    words("beyond.veerman.gain_iff", "if and only if 0 < w^2 < 2|f|")
    words("beyond.veerman.growth", "grows exponentially with M")
    f, g = gains(random.Random(case))
    best = (f / g) ** 2 * math.expm1(0.5 * math.log1p(2 * g * g / -f))
    gain = lambda square: abs(complex(f, math.sqrt(square) * g) / complex(f + square, math.sqrt(square) * g))  # noqa: E731
    assert best < -f and gain(best) > 1
    for square in -f * np.geomspace(1e-6, 1e3, 400):
        assert gain(square) <= gain(best) * (1 + 1e-14)
        assert (gain(square) > 1) == (square < -2 * f) or math.isclose(square, -2 * f, rel_tol=1e-9)


@pytest.mark.parametrize("case", range(40))
def test_how_many_cars_stay_within_a_bound(case: int) -> None:
    words("beyond.veerman.prop1", "then N + 1 <= 2 ln(D/a_0)/ln(1 + |f|/g^2)", "if N + 1 >= 1 is at most that")
    choose = random.Random(case)
    f, g = gains(choose)
    w = math.sqrt(-f)
    start, most = math.exp(choose.uniform(-2, 2)), math.exp(choose.uniform(-2, 6))
    bound = 2 * math.log(most / start) / math.log1p(-f / g**2)
    for cars in {1, 2, 5, math.floor(bound), math.floor(bound) + 1, 40} - {0}:
        if cars < 1 or abs(cars - bound) < 1e-6 * abs(bound) or cars > 10**4:
            continue
        size = start
        for _ in range(cars):
            size *= abs(complex(f, w * g) / complex(f + w * w, w * g))
        assert (size <= most) == (cars <= bound)
