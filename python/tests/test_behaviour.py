"""Copies, threads, progress, Ctrl-C, the command line in the wheel."""

from __future__ import annotations

import copy
import pickle
import signal
import subprocess
import sys
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

import pytest
from conftest import command_line

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
import signal, sys, threading, time
import flockproof
signal.signal(signal.SIGINT, signal.default_int_handler)
print("ready", flush=True)
try:
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
        assert process.stdout is not None and process.stdout.readline() == "ready\n"
        time.sleep(0.5)
        process.send_signal(signal.SIGINT)
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
