"""The laws of the papers from files (assets/laws) beside the built-in ones: user time of `simulate` and its ratio.

usage: python3 benches/own_laws.py [--flockproof PROGRAM] [--rounds N] [--only NAME] [--keep FOLDER]

Both get the same start, tolerance and times; no observables and two rows, so that the motion is what is measured. Rounds take turns; the least of each counts.
The last column is the largest difference of a number of the last row.
"""

import argparse
import csv
import pathlib
import random
import re
import resource
import subprocess
import sys
import tempfile

LAWS = pathlib.Path(__file__).resolve().parent.parent / "assets" / "laws"


def lattice(count, spacing, draw, jitter):
    side = int(count**0.5 + 0.999)
    return [[spacing * (k % side) + jitter * draw(), spacing * (k // side) + jitter * draw()] for k in range(count)]


def vectors(count, size, draw):
    return [[size * draw(), size * draw()] for _ in range(count)]


def cases():
    """Name, law, its graph and run, the starts of the law's file and of the built-in model, model and its law."""
    draw = random.Random(7).random
    signed = lambda: 2 * draw() - 1
    angles = lambda count: [6 * draw() for _ in range(count)]
    places, moving = lattice(200, 1.5, signed, 0.2), vectors(200, 0.5, signed)
    both = {"x": places, "v": moving}
    named = {"positions": places, "velocities": moving}
    yield "velocity alignment, 200 all to all", "velocity_alignment", 'kind = "complete"', 4, "", both, named, (
        "velocity-alignment", 'potential = "inverse-square-log"')
    many, speeds = lattice(5000, 1.5, signed, 0.2), vectors(5000, 0.5, signed)
    yield "velocity alignment, 5000 within a radius, fixed steps", "velocity_alignment", 'kind = "within"\nradius = "5/2"', 1, (
        'step = "1/100"'), {"x": many, "v": speeds}, {"positions": many, "velocities": speeds}, (
        "velocity-alignment", 'potential = "inverse-square-log"')
    yield "velocity alignment, 100 within a radius, located", "velocity_alignment", 'kind = "within"\nradius = "5/2"', 2, "", {
        "x": places[:100], "v": moving[:100]}, {"positions": places[:100], "velocities": moving[:100]}, (
        "velocity-alignment", 'potential = "inverse-square-log"')
    yield "heading alignment, 200 all to all", "heading_alignment", 'kind = "complete"', 2, "", both, named, (
        "heading-alignment", 'potential = "inverse-square-log"')
    phases = angles(400)
    yield "400 phases", "phase_model", 'kind = "complete"', 40, "", {"theta": phases}, {"phases": phases}, ("phase", 'omega0 = 0\nK1 = "-1"')
    few, turned = vectors(200, 5, signed), angles(200)
    yield "200 circling particles", "circling", 'kind = "complete"', 20, "", {"x": few, "theta": turned}, {"positions": few, "phases": turned}, (
        "particles", "omega0 = 1\nK0 = 1")
    school, ways = lattice(1000, 2, signed, 0.5), angles(1000)
    yield "1000 fish", "fish", None, 40, "", {"x": school, "theta": ways}, {"positions": school, "phases": ways}, (
        "fish", 'T = "1/10"\nomega0 = "1/5"\nKrep = 1\nKori = "1/10"\nKatt = "1/20"\nrepulsion = 1\norientation = 3\nattraction = 6')
    line = [-float(k) for k in range(300)]
    pushed = [0.0] + [signed() for _ in range(299)]
    edges = [[k, k + side] for k in range(2, 300) for side in (-1, 1)] + [[300, 299]]
    chain = f'kind = "edges"\ndirected = true\nedges = {edges}'
    yield "platoon of 300, both sides", "platoon_both_sides", chain, 60, "", {"x": line, "v": pushed}, {"positions": line, "velocities": pushed}, (
        "platoon", 'f = -1\ng = -1\ncommunication = "front-and-back"')


def listed(state):
    return "[state]\n" + "".join(f"{name} = {numbers}\n" for name, numbers in state.items())


def timed(program, path, out):
    before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    done = subprocess.run([program, "simulate", path, "--out", out], capture_output=True, text=True)
    if done.returncode:
        sys.exit(f"{path}: {done.stderr}")
    return resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before


def last(out):
    rows = list(csv.reader(open(pathlib.Path(out) / "trajectory.csv")))
    return [float(x) for row in rows[-1:] for x in row if re.fullmatch(r"[-+0-9.eE]+", x)]


def main():
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("--flockproof", default="target/release/flockproof")
    arguments.add_argument("--rounds", type=int, default=1)
    arguments.add_argument("--only", default="")
    arguments.add_argument("--keep", default="", help="a folder in which the files stay")
    asked = arguments.parse_args()
    print("| run | built-in [s] | file [s] | ratio | difference |\n|---|---|---|---|---|")
    with tempfile.TemporaryDirectory() as made:
        folder = asked.keep or made
        for name, law, graph, until, extra, own, built, (model, text) in cases():
            if asked.only not in name:
                continue
            file = (LAWS / f"{law}.toml").read_text()
            head = re.search(r"\n\[law\].*?(?=\n\[(graph|state|run)\])", file, re.S).group(0)
            head = re.sub(r"\[law\.observables\].*?(?=\n\[|\Z)", "", head, flags=re.S)
            # A place for each car; the built-in platoon and the fish have their network in the law.
            head = re.sub(r"place = \[.*?\]", f"place = {[-k for k in range(300)]}", head)
            shipped = re.search(r"\n\[graph\].*?(?=\n\[(state|run)\])", file, re.S)
            chart = f"[graph]\n{graph}\n" if graph else shipped.group(0) + "\n" if shipped else ""
            run = f"[run]\nuntil = {until}\nrows = 2\nobservables = []\ntolerance = 1e-9\n{extra}\n"
            paths = [f"{folder}/own.toml", f"{folder}/built.toml"]
            pathlib.Path(paths[0]).write_text(f'model = "own"\n{head}\n{chart}{listed(own)}{run}')
            others = f"[graph]\n{graph}\n" if graph and model != "platoon" else ""
            pathlib.Path(paths[1]).write_text(f'model = "{model}"\n[law]\n{text}\n{others}{listed(built)}{run}')
            times = [[], []]
            for _ in range(asked.rounds):
                for which in (1, 0):
                    times[which].append(timed(asked.flockproof, paths[which], f"{folder}/{which}"))
            mine, theirs = min(times[0]), min(times[1])
            apart = max((abs(a - b) for a, b in zip(last(f"{folder}/0"), last(f"{folder}/1"))), default=float("nan"))
            print(f"| {name} | {theirs:.2f} | {mine:.2f} | {mine / theirs:.2f} | {apart:.1e} |", flush=True)


if __name__ == "__main__":
    main()
