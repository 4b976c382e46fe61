"""Platoons with weights: against the equations in exact complex arithmetic, SciPy and python-control."""

import subprocess
import sys

import numpy as np
import pytest

import flockproof

AHEAD = ["0.6", "0.55", "0.7", "0.6", "0.5"]
CARS = {"f": ["-1", "-2", "-1/3", "-1", "-3/2"], "g": [-2, -1, -2, -3, -1], "f_ahead": AHEAD, "g_behind": "1/4"}


def written_out(w):
    """The amplitudes by the equations of motion, in floating point."""
    f, g = ([float(flockproof.exact(x)) for x in CARS[name]] for name in "fg")
    matrix, right = np.zeros((5, 5), complex), np.zeros(5, complex)
    for k in range(5):
        p = 1 if k == 4 else float(flockproof.exact(AHEAD[k]))
        v = 1 if k == 4 else 0.75
        matrix[k, k] = -(w**2) - f[k] - 1j * w * g[k]
        ahead, behind = f[k] * p + 1j * w * g[k] * v, f[k] * (1 - p) + 1j * w * g[k] * (1 - v)
        if k == 0:
            right[0] = -ahead
        else:
            matrix[k, k - 1] = ahead
        if k < 4:
            matrix[k, k + 1] = behind
    return np.linalg.solve(matrix, right)


def test_responses_are_those_of_the_equations():
    platoon = flockproof.Platoon(5, **CARS)
    for w in ("1/10", "0.7", 3):
        known = written_out(float(flockproof.exact(w)))
        for car in range(1, 6):
            found = platoon.response(w, car)
            assert abs(complex(found) - known[car - 1]) < 1e-12
            assert (found.car, found.frequency) == (car, w)


def test_the_peak_is_that_of_a_scan():
    platoon = flockproof.Platoon(5, **CARS)
    scan = np.array([np.abs(written_out(w)) for w in np.linspace(0.001, 5, 20001)])
    for car in (1, 5):
        peak = platoon.peak(car)
        assert scan[:, car - 1].max() <= float(peak.amplitude) * (1 + 1e-12)
        assert scan[:, car - 1].max() > float(peak.amplitude) * (1 - 1e-6)
    assert platoon.peak().amplitude == platoon.peak(5).amplitude


def test_weights_of_one_half_are_the_platoon_of_the_paper():
    plain = flockproof.resonance(7, -1, -2, digits=10).amplitude
    for weights in ({}, {"ahead": "1/2"}, {"behind": list(range(1, 8)), "ahead": list(range(1, 8))}):
        found = flockproof.Platoon(7, -1, -2, **weights).peak(digits=10).amplitude
        assert abs(float(found) - float(plain)) < 1e-9
    assert abs(float(flockproof.Platoon(7, -1, -2, ahead="3/5").peak().amplitude) - float(plain)) > 0.1


def test_poles_are_the_eigenvalues():
    platoon = flockproof.Platoon(5, **CARS)
    known = sorted(np.linalg.eigvals(platoon.matrices()[0]), key=lambda z: (z.real, z.imag))
    found = [complex(pole) for pole in platoon.poles() for _ in range(pole.multiplicity)]
    found.sort(key=lambda z: (z.real, z.imag))
    assert np.allclose(found, known, atol=1e-6)


def test_models_of_scipy_and_python_control():
    platoon = flockproof.Platoon(5, **CARS)
    w = np.array([0.1, 0.7, 3.0])
    known = np.array([written_out(x) for x in w]).T
    signal = pytest.importorskip("scipy.signal")
    model = platoon.to_scipy()
    assert isinstance(model, signal.StateSpace)
    by_scipy = np.array([model.C @ np.linalg.solve(1j * x * np.eye(10) - model.A, model.B @ [1, 1j * x]) for x in w]).T
    assert np.allclose(by_scipy, known)
    pytest.importorskip("control")
    model = platoon.to_control()
    assert model.state_labels[:3] == ["y_1", "u_1", "y_2"] and model.input_labels == ["y_0", "u_0"]
    values = model(1j * w)
    assert np.allclose(values[:, 0, :] + 1j * w * values[:, 1, :], known)
    # The first input alone is another thing.
    assert not np.allclose(values[:, 0, :], known)


def test_what_is_wrong_says_so():
    make = flockproof.Platoon
    for words, wrong in [
        ("f must be negative, but it is 1: the law is", lambda: make(3, 1, -1)),
        ("ahead has 2 numbers for 3 followers", lambda: make(3, -1, -1, ahead=[1, 1])),
        ("ahead and g_ahead cannot both be given", lambda: make(3, -1, -1, ahead=1, g_ahead=1)),
        ("g is needed", lambda: make(3, -1)),
        ("the followers 1 to 3", lambda: make(3, -1, -1).peak(4)),
        ("not stable", lambda: make(60, -1, -1, f_ahead="0.6", g_ahead="1/2").peak()),
        ("frequency must not be negative", lambda: make(3, -1, -1).response(-1)),
        ("none of the extras", lambda: flockproof.require("plots")),
    ]:
        with pytest.raises(ValueError, match=words):
            wrong()


def test_floats_are_told():
    assert flockproof.Platoon(2, -1, -1, ahead=0.6).from_floats
    assert not flockproof.Platoon(2, -1, -1, ahead="0.6").from_floats


def test_bode_draws_magnitude_phase_and_peaks():
    pytest.importorskip("matplotlib").use("Agg")
    from flockproof import plot

    axes = plot.bode(flockproof.Platoon(5, -1, -1, ahead="0.6"), cars=[1, 5])
    assert len(axes) == 2 and len(axes[0].get_lines()) == 4 and len(axes[1].get_lines()) == 2
    with pytest.raises(ValueError, match="none of the followers"):
        plot.bode(flockproof.Platoon(5, -1, -1), cars=[6])


def test_a_missing_extra_is_named():
    program = (
        "import sys, flockproof\n"
        "for name in ('control', 'pandas', 'matplotlib'): sys.modules[name] = None\n"
        "for ask in (lambda: flockproof.Platoon(2, -1, -1).to_control(), lambda: flockproof.ledger().to_pandas()):\n"
        "    try: ask()\n"
        "    except ImportError as error: print(error)\n"
    )
    told = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=True).stdout
    assert 'control is needed for this: pip install "flockproof[control]"' in told
    assert 'pandas is needed for this: pip install "flockproof[pandas]"' in told


def test_a_text_is_a_list():
    listed = flockproof.Platoon(3, f=-1, g=[-2, -2, -1], ahead=["0.6", "1/2", 1])
    for ahead in ("0.6,1/2,1", "[0.6, 1/2, 1]", "each:3/5,1/2,1"):
        same = flockproof.Platoon(3, f="-1", g="-2,-2,-1", ahead=ahead)
        assert str(same.peak().amplitude) == str(listed.peak().amplitude)
    with pytest.raises(ValueError, match="ahead: `x`"):
        flockproof.Platoon(3, f=-1, g=-2, ahead="0.6,x,1")
