"""SciPy's cKDTree, as range_scipy.c asks it:

    range_scipy.py FOLDER DIMENSIONS K DISTANCE

FOLDER/points has rows of coordinates. Printed are the times to build,
to find the K nearest of each point and to count all within the
distance, in ns, and how many these are, each point itself included. The
squared distances to the K nearest go to FOLDER/nearest2. Without
arguments it does nothing, if there is a SciPy.
"""

import sys
from time import perf_counter_ns

import numpy
from scipy.spatial import cKDTree


def ask(folder, d, k, distance):
    points = numpy.fromfile(folder + "/points").reshape(-1, d)
    begin = perf_counter_ns()
    tree = cKDTree(points)
    built = perf_counter_ns()
    # One more, since the query finds itself.
    nearest, _ = tree.query(points, k + 1, workers=1)
    found = perf_counter_ns()
    counts = tree.query_ball_point(
        points, distance, workers=1, return_length=True
    )
    end = perf_counter_ns()
    (nearest[:, 1:] ** 2).tofile(folder + "/nearest2")
    print(built - begin, found - built, end - found, counts.sum())


if len(sys.argv) > 1:
    ask(sys.argv[1], int(sys.argv[2]), int(sys.argv[3]), float(sys.argv[4]))
