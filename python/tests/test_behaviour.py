"""Copies, threads, progress, Ctrl-C, the command line in the wheel."""

from __future__ import annotations

import copy
import pickle
import signal
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from fractions import Fraction
from pathlib import Path
from typing import Any

import pytest
from conftest import answer, command_line

import flockproof


def objects(assets: Path) -> list[Any]:
    flock = flockproof.Flock.from_file(assets / "four_birds.json")
    return [
        flockproof.resonance(9, -1, "-1/2"),
        flockproof.spectrum("ring:7"),
        flockproof.ergodicity(assets / "two_matrices.txt"),
        flock,
        flock.settle(),
        flock.run(12, products=True),
        flockproof.simulate(assets / "scenarios" / "three_agents.toml"),
        flockproof.ledger(),
        flockproof.verify(claims="veerman.lem2"),
    ]


def test_copies_are_equal_and_show_themselves(assets: Path) -> None:
    for thing in objects(assets):
        again = pickle.loads(pickle.dumps(thing))
        assert again == thing == copy.copy(thing) == copy.deepcopy(thing)
        assert repr(again) == repr(thing) and "object at" not in repr(thing)
        assert thing != object()
        if type(thing).__hash__ is not None:
            assert hash(again) == hash(thing)
        if hasattr(thing, "_repr_html_"):
            assert thing._repr_html_().startswith("<")


def test_objects_do_not_change(assets: Path) -> None:
    for thing in objects(assets):
        if not isinstance(thing, (list, flockproof.Claims, flockproof.Ledger)):
            with pytest.raises(AttributeError):
                thing.declaration = "x"


def test_equal_flocks_are_equal_however_their_numbers_are_written() -> None:
    written = [
        flockproof.Flock([0, "1/2"], ["1/8", 0]),
        flockproof.Flock(["0.0", 0.5], [Fraction(1, 8), 0]),
        flockproof.Flock.from_json(
            '{"model": "D", "weights": "lazy", "positions": [[0], ["2/4"]], "velocities": [[0.125], [0]]}'
        ),
    ]
    assert len(set(written)) == 1
    assert written[0] != flockproof.Flock([0, "1/2"], ["1/8", 1])


def test_files_may_have_a_byte_order_mark(assets: Path, tmp_path: Path) -> None:
    def marked(name: str) -> Path:
        path = tmp_path / Path(name).name
        path.write_bytes(b"\xef\xbb\xbf" + (assets / name).read_bytes())
        return path

    assert flockproof.spectrum(marked("graphs/bridge.txt")) == flockproof.spectrum(assets / "graphs/bridge.txt")
    assert flockproof.ergodicity(marked("two_matrices.txt")) == flockproof.ergodicity(assets / "two_matrices.txt")
    assert flockproof.Flock.from_file(marked("four_birds.json")).birds == 4
    assert flockproof.simulate(marked("scenarios/three_agents.toml")).model == "velocity-alignment"
    assert flockproof.tracks(marked("example_tracks.csv"), null=0).summary["fish"]
    assert flockproof.check(marked("questions/algebraic_connectivity.toml")).verdict == "holds"


def test_one_of_many_runs(assets: Path) -> None:
    scenario = assets / "scenarios" / "noise_sweep.toml"
    with pytest.raises(ValueError, match="the scenario makes 56 runs: choose one of them, member=1 to 56"):
        flockproof.simulate(scenario)
    with pytest.raises(ValueError, match="member: there are the runs 1 to 56"):
        flockproof.simulate(scenario, member=61)
    first, second = flockproof.simulate(scenario, member=1), flockproof.simulate(scenario, member=2)
    assert first == flockproof.simulate(scenario, member=1) != second
    assert not (first.states["phases"][0] == second.states["phases"][0]).any()


def test_rows_of_floats_are_normalised(assets: Path) -> None:
    third = [[[1 / 3] * 3] * 3]
    with pytest.raises(ValueError, match="normalise=True divides each row by its sum"):
        flockproof.ergodicity(third)
    found = flockproof.ergodicity(third, normalise=True)
    assert found.tau_1 == 0 and set(found.product[0]) == {Fraction(1, 3)} and len(found.changed) == 3
    assert found.from_floats
    # As the command line does it.
    file = assets / "float_matrices.json"
    told = answer("ergodicity", str(file), "--normalise")
    found = flockproof.ergodicity(file, normalise=True)
    assert [[str(x) for x in row] for row in found.product] == told["product"]
    assert len(found.changed) == len(told["changed"])
    with pytest.raises(ValueError, match=r"this is one matrix: write \[matrix\]"):
        flockproof.ergodicity([[1, 0], [0, 1]])


def test_products_have_their_least_denominator() -> None:
    half = [["1/2", "1/2"], ["1/2", "1/2"]]
    assert flockproof.ergodicity([half, half]).product.denominator == 2
    found = flockproof.ergodicity([[["4/5", "1/5"], ["2/3", "1/3"]], [["1/2", "1/2"], [0, 1]]])
    assert found.product.denominator == 15


def test_files_that_count_from_zero(assets: Path) -> None:
    file = assets / "graphs" / "networkx.txt"
    with pytest.raises(ValueError, match="for a file that counts from 0 there is zero_based=True"):
        flockproof.spectrum(file)
    assert flockproof.spectrum(file, zero_based=True).order > 2
    with pytest.raises(ValueError, match="ring:5 names a graph"):
        flockproof.spectrum("ring:5", zero_based=True)


def test_threads_get_the_same_answers() -> None:
    flock = flockproof.Flock([0, "1/2", "5/4"], ["1/8", 0, "-1/8"])

    def ask(k: int) -> tuple[Any, ...]:
        return flockproof.resonance(k + 1, -1, -1), flockproof.spectrum(f"ring:{k + 3}"), flock.settle(), flock.run(30)

    alone = [ask(k) for k in range(16)]
    with ThreadPoolExecutor(8) as pool:
        assert list(pool.map(ask, range(16))) == alone


def test_progress_is_told_and_may_stop() -> None:
    told: list[tuple[str, int, int | None]] = []
    flockproof.verify("veerman", ["veerman.lem2", "veerman.gain_max"], progress=lambda *step: told.append(step))
    assert told[-1] == ("claims", 2, 2)

    def stop(stage: str, done: int, total: int | None) -> None:
        raise RuntimeError("enough")

    with pytest.raises(RuntimeError, match="enough"):
        flockproof.Flock([0, "1/2"], ["1/8", 0]).run(10**9, progress=stop)


LONG = {
    "flock": "flockproof.Flock([0, '1/2', 1], ['1/8', 0, '1/9']).run(10**9)",
    "digits": "[flockproof.resonance(10**9, -1, -1, digits=10000) for _ in range(1000)]",
    "spectrum": "[flockproof.spectrum('geometric:900:1/4:7') for _ in range(1000)]",
    "ledger": "flockproof.verify(full=True)",
    "simulate": "flockproof.simulate({'model': 'phase', 'state': {'random': {'agents': 500}}, 'law': {'K1': -1}, "
    "'run': {'until': 1000000}})",
    "products": "flockproof.ergodicity([[['1/3', '2/3'], ['1/7', '6/7']]] * 10**5)",
}

PROGRAM = """
import os, signal, sys, threading
import flockproof

def interrupt(main, folder):
    # Once the main thread is in a function of the package, however long that takes.
    while not sys._current_frames()[main].f_code.co_filename.startswith(folder):
        pass
    os.kill(os.getpid(), signal.SIGINT)

signal.signal(signal.SIGINT, signal.default_int_handler)
where = (threading.get_ident(), os.path.dirname(flockproof.__file__))
watcher = threading.Thread(target=interrupt, args=where, daemon=True)
try:
    watcher.start()
    {call}
except KeyboardInterrupt:
    print("stopped", flush=True)
except ValueError as error:
    print(error, flush=True)
"""


@pytest.mark.skipif(sys.platform == "win32", reason="signals are sent as on Unix")
@pytest.mark.parametrize("name", LONG)
def test_ctrl_c_stops(name: str) -> None:
    program = PROGRAM.format(call=LONG[name])
    with subprocess.Popen([sys.executable, "-c", program], stdout=subprocess.PIPE, text=True) as process:
        assert process.stdout is not None
        # Abandoned work ends with the process; no test asserts a duration.
        assert process.stdout.readline() == "stopped\n"
        assert process.wait() == 0


def test_the_command_line_is_in_the_wheel() -> None:
    assert command_line("--version").stdout.strip() == f"flockproof {flockproof.__version__}"
    assert command_line("resonance").returncode == 2
    assert command_line("nothing").stderr.startswith("error")


@pytest.mark.skipif(sys.platform == "win32", reason="signals are sent as on Unix")
def test_ctrl_c_stops_the_command_line(assets: Path) -> None:
    command = [
        sys.executable,
        "-m",
        "flockproof",
        "flock",
        "run",
        str(assets / "four_birds.json"),
        "--until",
        "1000000000",
    ]
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as process:
        assert process.stdout is not None
        process.stdout.readline()
        process.send_signal(signal.SIGINT)
        process.communicate()
        assert process.returncode == 130
