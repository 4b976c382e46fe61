"""Growth of cost: runs each command at three sizes and prints the exponents of its CPU time, a table for notes/growth.md.

usage: python3 benches/growth.py [--doubling SECONDS] [PROGRAM] [FILTER]      (default target/release/flockproof; from anywhere)

CPU time (user and system) less that of `--version`, the least of two runs; so a busy machine changes little. Exit status 1 where the
exponent from the second to the third size is above what the reason given allows by more than 0.4.

With --doubling the search for growth goes on from there: sizes are doubled until a run takes so many seconds or fails, and the last
exponent counts.
"""
import json
import math
import os
import resource
import subprocess
import sys
import tempfile

RUNS = 2
ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))


def draws(seed):
    x = seed
    while True:
        x = (6364136223846793005 * x + 1442695040888963407) % 2**64
        yield x >> 33


def crowd(n, folder):
    g = draws(n)
    side = int((n / 2.5) ** 0.5 * 1024)
    place = lambda: ["%d/1024" % (next(g) % side) for _ in range(2)]
    speed = lambda: ["%d/8192" % (next(g) % 1024 - 512) for _ in range(2)]
    flock = {"model": "D", "dimension": 2, "weights": "lazy", "hysteresis": "none"}
    flock["positions"], flock["velocities"] = [place() for _ in range(n)], [speed() for _ in range(n)]
    return write(folder, "crowd.json", json.dumps(flock))


def sparse_crowd(n, folder, degree=4):
    """Birds with some four neighbours: flocks of all sizes that merge for a long time."""
    g = draws(n)
    side = int((n * math.pi / degree) ** 0.5 * 1024)
    place = lambda: ["%d/1024" % (next(g) % side) for _ in range(2)]
    speed = lambda: ["%d/8192" % (next(g) % 1024 - 512) for _ in range(2)]
    flock = {"model": "D", "dimension": 2, "weights": "lazy", "hysteresis": "none"}
    flock["positions"], flock["velocities"] = [place() for _ in range(n)], [speed() for _ in range(n)]
    return write(folder, "sparse.json", json.dumps(flock))


def lattice(side, folder):
    """Every neighbour at distance exactly 1, all in one motion."""
    places = [["%d" % i, "%d" % j] for i in range(side) for j in range(side)]
    flock = {"model": "D", "dimension": 2, "weights": "lazy", "hysteresis": "none"}
    flock["positions"], flock["velocities"] = places, [["1/7", "1/7"] for _ in places]
    return write(folder, "lattice.json", json.dumps(flock))


def line(n, folder):
    """A slow line, which settles in the square of its length."""
    g = draws(n)
    flock = {"model": "D", "dimension": 1, "weights": "lazy", "hysteresis": "none"}
    flock["positions"] = [["%d/10" % (9 * i)] for i in range(n)]
    flock["velocities"] = [["%d/8192000" % (next(g) % 1024 - 512)] for _ in range(n)]
    return write(folder, "line.json", json.dumps(flock))


def identities(count, folder):
    return write(folder, "identities.txt", "\n\n".join(["1 0\n0 1"] * count) + "\n")


def edges_of_their_own(n, folder):
    return write(folder, "edges.txt", "\n".join("%d %d" % (2 * k + 1, 2 * k + 2) for k in range(n)) + "\n")


def directed_chain(n, folder):
    lines = ["%%%%MatrixMarket matrix coordinate real general", "%d %d %d" % (n, n, n - 1)]
    return write(folder, "chain.mtx", "\n".join(lines + ["%d %d 1" % (k, k + 1) for k in range(1, n)]) + "\n")


def factors(length, n, folder):
    g = draws(length + n)
    row = lambda: [1 + next(g) % 100 for _ in range(n)]
    lines = lambda weights: " ".join("%d/%d" % (w, sum(weights)) for w in weights)
    matrices = ["\n".join(lines(row()) for _ in range(n)) for _ in range(length)]
    return write(folder, "factors.txt", "\n\n".join(matrices) + "\n")


def weighted(n, folder):
    g = draws(n)
    edges = ["%d %d %d" % (i + 1, j + 1, 1 + next(g) % 9) for i in range(n) for j in range(i) if next(g) % 2]
    return write(folder, "weighted.txt", "\n".join(edges) + "\n")


def scenario(agents, steps, folder):
    text = 'model = "vicsek-noise"\n[state]\nrandom = { agents = %d, seed = 1, half = "%d/2" }\n' % (agents, round(agents**0.5))
    text += '[law]\nbox = %d\nspeed = "3/100"\nnoise = "1/10"\nseed = 1\n[run]\nuntil = %d\nsamples = [%d]\n' % (
        round(agents**0.5), steps, steps)
    return write(folder, "scenario.toml", text)


ALIGNING = 'potential = "inverse-square-log"'


def located(model, law, agents, folder, graph='kind = "within"\nradius = 2'):
    text = 'model = "%s"\n[graph]\n%s\n[state]\n' % (model, graph)
    text += 'random = { agents = %d, seed = 1, place = "grid", spacing = 1, half = "3/10" }\n' % agents
    text += '[law]\n%s\n[run]\nuntil = 1\nrows = 2\ntolerance = 1e-8\n' % law
    return write(folder, "located.toml", text)


def steered(n):
    return "omega0 = 1\nK0 = %d\nK1 = -%d" % (n // 20, n // 5)


def school(fish, frames, folder):
    g = draws(fish)
    rows = ["t,id,x,y"]
    for k in range(fish):
        x, y, a = next(g) % 50, next(g) % 50, next(g) % 7
        rows += ["%.1f,f%d,%.4f,%.4f" % (t / 10, k, x + t * math.cos(a + t / 200), y + t * math.sin(a)) for t in range(frames)]
    return write(folder, "school.csv", "\n".join(rows) + "\n")


def write(folder, name, text):
    path = os.path.join(folder, name)
    with open(path, "w") as handle:
        handle.write(text)
    return path


def command(*words):
    return lambda size, folder: [w if isinstance(w, str) else str(w(size, folder)) for w in words]


SIZE = lambda size, folder: size
OUT = lambda size, folder: os.path.join(folder, "out")
NAME = lambda kind: lambda size, folder: "%s:%d" % (kind, size)
# (what, what grows, sizes, command, the exponent that the reason allows, reason)
ROWS = [
    ("resonance", "followers", [10**3, 10**6, 10**9],
     command("resonance", "--followers", SIZE, "--f", "-1", "--g", "-1", "--digits", "25"), 0.0,
     "powers of two numbers by squaring: the logarithm of the number of followers"),
    ("resonance", "digits", [100, 200, 400],
     command("resonance", "--followers", "1000", "--f", "-1", "--g", "-1", "--digits", SIZE), 2.0,
     "as many bits in every product, and steps that double the digits"),
    ("spectrum, closed form", "vertices", [1000, 4000, 16000], command("spectrum", "--json", "--graph", NAME("path")), 1.0,
     "one cosine an eigenvalue"),
    ("spectrum, dense file", "vertices", [60, 120, 240], command("spectrum", "--json", "--graph", lambda n, f: weighted(n, f)), 3.0,
     "a full symmetric matrix and its residual"),
    ("ergodicity", "factors", [100, 200, 400], command("ergodicity", "--json", lambda n, f: factors(n, 6, f)), 3.0,
     "every prefix is brought to lowest terms, the square of its length for each"),
    ("ergodicity, identities", "factors", [2000, 4000, 8000], command("ergodicity", "--json", lambda n, f: identities(n, f)), 1.0,
     "levels that are equal are looked at once"),
    ("spectrum, single edges", "edges", [2000, 4000, 8000], command("spectrum", "--json", "--graph", lambda n, f: edges_of_their_own(n, f)),
     1.0, "blocks with the same polynomial count once"),
    ("spectrum, directed chain", "vertices", [4000, 8000, 16000],
     command("spectrum", "--json", "--kind", "adjacency", "--graph", lambda n, f: directed_chain(n, f)), 1.0, "blocks of one vertex"),
    ("ergodicity", "order", [6, 12, 24], command("ergodicity", "--json", lambda n, f: factors(60, n, f)), 4.0,
     "its square numbers, as long as the order, multiplied at the square of their length"),
    ("flock run", "birds", [200, 400, 800], command("flock", "run", lambda n, f: crowd(n, f), "--until", "2000", "--json"), 2.0,
     "switches times birds: after each one the lists of pairs are made again (exact_flocks.md)"),
    ("flock run", "steps", [5000, 10000, 20000], command("flock", "run", lambda n, f: crowd(100, f), "--until", SIZE, "--json"), 1.0,
     "two limbs throughout"),
    ("flock run, lattice", "side", [16, 32, 64], command("flock", "run", lambda n, f: lattice(n, f), "--until", "100", "--json"), 2.0,
     "birds; above 1000 of them without footprints"),
    ("flock settle", "birds", [60, 120, 240], command("flock", "settle", lambda n, f: crowd(n, f), "--json"), 3.0,
     "steps until the slowest flock has settled, its diameter squared"),
    ("flock settle, sparse", "birds", [500, 1000, 2000], command("flock", "settle", lambda n, f: sparse_crowd(n, f), "--json"), 2.0,
     "birds times steps until the last switch, which grow as fast"),
    ("flock settle, ties", "side", [16, 32, 64], command("flock", "settle", lambda n, f: lattice(n, f), "--json"), 2.0,
     "birds: those who move alike keep their distances"),
    ("flock settle, line", "birds", [100, 200, 400], command("flock", "settle", lambda n, f: line(n, f), "--json"), 3.0,
     "the square of the length in steps ahead, each as long"),
    ("simulate", "agents", [1000, 4000, 16000], command("simulate", lambda n, f: scenario(n, 100, f), "--out", OUT), 1.0,
     "neighbours from cells of the plane; bytes written"),
    ("simulate", "steps", [200, 400, 800], command("simulate", lambda n, f: scenario(1000, n, f), "--out", OUT), 1.0, "steps"),
    ("simulate, located switches", "agents", [1000, 4000, 16000],
     command("simulate", lambda n, f: located("velocity-alignment", ALIGNING, n, f), "--out", OUT), 1.0,
     "a switch costs those that notice it (integrators.md)"),
    ("simulate, located headings", "agents", [1000, 4000, 16000],
     command("simulate", lambda n, f: located("heading-alignment", ALIGNING, n, f), "--out", OUT), 1.0, "the same"),
    ("simulate, located particles", "agents", [1000, 4000, 16000],
     command("simulate", lambda n, f: located("particles", steered(n), n, f), "--out", OUT),
     1.0, "the same"),
    ("simulate, located nearest", "agents", [1000, 4000, 16000],
     command("simulate", lambda n, f: located("particles", steered(n), n, f, 'kind = "nearest"\nnearest = 5'), "--out", OUT),
     1.0, "the same"),
    ("tracks", "frames", [500, 1000, 2000], command("tracks", lambda n, f: school(8, n, f), "--out", OUT), 1.0, "frames"),
    ("tracks", "fish", [8, 16, 32], command("tracks", lambda n, f: school(n, 300, f), "--out", OUT), 2.0,
     "networks and potentials of all pairs"),
    ("fuzz", "cases", [20000, 40000, 80000], command("fuzz", "momentum.velocity_alignment", "--cases", SIZE), 1.0, "cases"),
]


def cpu(words):
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    done = subprocess.run(words, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    if done.returncode not in (0, 3):
        sys.exit("%s: %s" % (" ".join(words), done.stderr.strip()))
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def measured(program, start, make, size):
    with tempfile.TemporaryDirectory() as folder:
        words = [program, *make(size, folder)]
        return max(min(cpu(words) for _ in range(RUNS)) - start, 1e-3)


def main():
    longest = 0.0
    if "--doubling" in sys.argv:
        place = sys.argv.index("--doubling")
        longest = float(sys.argv[place + 1])
        del sys.argv[place:place + 2]
    program = next((a for a in sys.argv[1:] if os.path.isfile(a)), os.path.join(ROOT, "target", "release", "flockproof"))
    wanted = next((a for a in sys.argv[1:] if not os.path.isfile(a)), "")
    start = min(cpu([program, "--version"]) for _ in range(3))
    failed = False
    print("| command | what grows | sizes | CPU [s] | exponents | why |\n|---|---|---|---|---|---|")
    for what, grows, sizes, make, allowed, why in ROWS:
        if wanted not in what:
            continue
        times = [measured(program, start, make, size) for size in sizes]
        while times[-1] * 2 ** max(allowed, 1) < longest and sizes[-1] < 10**9:
            sizes = sizes + [2 * sizes[-1]]
            times.append(measured(program, start, make, sizes[-1]))
        steps = list(zip(sizes, sizes[1:], times, times[1:]))
        exponents = [math.log(t / s) / math.log(b / a) for a, b, s, t in steps]
        failed |= exponents[-1] > allowed + 0.4
        mark = "" if exponents[-1] <= allowed + 0.4 else " ABOVE %g" % allowed
        cells = (what, grows, ", ".join(map(str, sizes)), ", ".join("%.3g" % t for t in times),
                 ", ".join("%.1f" % e for e in exponents) + mark, why)
        print("| %s |" % " | ".join(cells), flush=True)
    sys.exit(1 if failed else 0)


if __name__ == "__main__":
    main()
