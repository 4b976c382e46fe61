"""W10: one spectral inequality on all small graphs.

usage: python w10_graphs.py atlas

For each of the 1252 graphs on 1 to 7 vertices of networkx's atlas, NumPy's eigenvalues of the Laplacian: is the second one at most
n/(n - 1) times the smallest degree (Fiedler), up to 1e-9? Reading the atlas is timed, as making the graphs is on our side.
"""
import os

for name in ("OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS", "MKL_NUM_THREADS"):
    os.environ.setdefault(name, "1")

import networkx
import numpy
from networkx.generators.atlas import graph_atlas_g

from common import best_of, emit


def violations():
    count = graphs = 0
    for graph in graph_atlas_g():
        n = graph.number_of_nodes()
        if n == 0:
            continue
        graphs += 1
        if n == 1:
            continue
        adjacency = networkx.to_numpy_array(graph)
        degrees = adjacency.sum(axis=1)
        values = numpy.linalg.eigvalsh(numpy.diag(degrees) - adjacency)
        count += bool(values[1] > n / (n - 1) * degrees.min() + 1e-9)
    assert graphs == 1252
    return count


def main():
    seconds, count = best_of(violations)
    version = "networkx %s, numpy %s" % (networkx.__version__, numpy.__version__)
    emit("W10", "networkx", version, "n<=7,graphs=1252", seconds, "violations=%d" % count)


if __name__ == "__main__":
    main()
