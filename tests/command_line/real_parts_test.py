#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 scan_to_path developers
# SPDX-License-Identifier: Apache-2.0
"""Scanned meshes of real parts, from emulation to path, against the meshes themselves (SCAN_TO_PATH_DATA: where they lie).

usage: real_parts_test.py EXECUTABLE SOURCE_DIRECTORY
"""
import csv
import json
import math
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

from mesh_oracle import Cells, Mesh, distance_to_segment, is_inside, read_ply

SKIPPED = 77
EXECUTABLE, SOURCE = (pathlib.Path(argument).resolve() for argument in sys.argv[1:3])
del sys.argv[1:3]
DATA = os.environ.get("SCAN_TO_PATH_DATA")
LARGEST = 1e-4  # [m] path off the mesh: the bar
UNCUT = 1e-3  # [m] left on the mesh; more was not reached by any row. As `reference_uncut_share` counts


class Part:
    """A part scanned and its path planned with its configuration; everything in the part's own frame."""

    def __init__(self, name, *flags, scale=1.0):
        file = pathlib.Path(DATA, name + ".ply")
        self.mesh = Mesh(*read_ply(file, scale))
        config = SOURCE / "config" / (name + ".yaml")
        with tempfile.TemporaryDirectory(prefix="scan_to_path_") as directory:
            log, out = pathlib.Path(directory, "samples.csv"), pathlib.Path(directory, "out")
            run("emulate", "--config", config, "--workpiece", file, *flags, "--out", log)
            run("plan", "--config", config, "--input", log, "--stop-after", "path", "--out", out)
            self.report = json.loads((out / "report.json").read_text())
            text = (out / "path.csv").read_text()
        pose = self.report["config"]["cell"]["workpiece"]
        assert pose["rpy"] == [0.0, 0.0, 0.0], "this oracle knows shifted parts only"
        self.moves = list(worked_moves(text, pose["xyz"]))
        self.radius = self.report["config"]["path"]["ball_radius"]
        self.reach = 1.5 * self.report["config"]["emulate"]["raster"]["pitch"]  # [m] of a row to both its sides

    def failed_tolerances(self):
        return [name for name, figure in self.report["accuracy"].items() if not figure.get("pass", True)]


def run(*arguments):
    """Status 1 is no failure here: the ball does not fit into these parts' folds, which is said and not cut."""
    done = subprocess.run([EXECUTABLE, *arguments, "--quiet"], check=False, stderr=subprocess.PIPE, text=True)
    assert done.returncode in (0, 1), done.stderr


def rotated_z(x, y, z, w):
    """Third column of a quaternion's rotation: the contact frame's normal."""
    return 2.0 * (x * z + w * y), 2.0 * (y * z - w * x), 1.0 - 2.0 * (x * x + y * y)


def worked_moves(text, origin):
    """Contacts (point, normal) at both ends of every move with the tool at work, less the part's place."""
    rows = csv.DictReader(line for line in text.splitlines() if not line.startswith("#"))
    before = None
    for row in rows:
        point = tuple(float(row[axis]) - origin[k] for k, axis in enumerate("xyz"))
        normal = rotated_z(*(float(row["q" + axis]) for axis in "xyzw"))
        if row["process_on"] == "1":
            yield before, (point, normal)
        before = point, normal


def places(moves, spacing=1e-3):
    """Points of the straight moves, their ends included, each once."""
    last = None
    for (a, _), (b, _) in moves:
        count = max(1, math.ceil(math.dist(a, b) / spacing))
        for k in range(0 if a != last else 1, count + 1):
            yield tuple(a[axis] + (b[axis] - a[axis]) * k / count for axis in range(3))
        last = b


def uncovered_share(part, moves, spacing=2.5e-3):
    """Share of the mesh's upper side on which a ball along the moves leaves more than UNCUT."""
    centre_moves = Cells(part.reach, part.reach)
    for move in moves:
        centres = tuple(tuple(p[k] + part.radius * n[k] for k in range(3)) for p, n in move)
        centre_moves.add(centres, [p for p, _ in move])  # by its contacts: what covers a place is near it
    points = list(part.mesh.area_points(spacing))
    uncut = sum(1 for p in points if not any(distance_to_segment(p, *move) <= part.radius + UNCUT
                                             for move in centre_moves.near(p[0], p[1])))
    return uncut / len(points)


def largest_distance(mesh, moves):
    return max(mesh.distance(p) for p in places(moves))


def shifted(moves, by):
    return [tuple(((p[0], p[1], p[2] + by), n) for p, n in move) for move in moves]


class RealParts(unittest.TestCase):
    def check(self, part, most_uncovered):
        self.assertEqual(part.failed_tolerances(), [])
        largest = largest_distance(part.mesh, part.moves)
        uncovered = uncovered_share(part, part.moves)
        print(f"{len(part.moves)} worked moves, largest {1e6 * largest:.1f} um off the mesh, "
              f"{100 * uncovered:.2f} % of it not covered")
        self.assertLessEqual(largest, LARGEST)
        self.assertLessEqual(uncovered, most_uncovered)
        for hole in part.mesh.holes():
            self.assertFalse([p for p in places(part.moves) if is_inside(p[0], p[1], hole)])
        # The twins: a part that lies elsewhere, and a path without its last twentieth.
        self.assertGreater(largest_distance(part.mesh, shifted(part.moves, 2e-4)), LARGEST)
        self.assertGreater(uncovered_share(part, part.moves[: int(0.95 * len(part.moves))]), most_uncovered)

    def test_a_wavy_mesh_with_a_hole(self):
        scale = 0.1 / 10.5
        part = Part("wavy_mesh_with_hole", "--scale", repr(scale), scale=scale)
        self.assertEqual(len(part.mesh.holes()), 1)
        self.check(part, 0.01)
        across = [((0.0, y, 0.0), (0.1, y, 0.0)) for y in (0.001 * k for k in range(101))]
        moves = [tuple((p, (0.0, 0.0, 1.0)) for p in ends) for ends in across]
        hole = part.mesh.holes()[0]
        self.assertTrue([p for p in places(moves) if is_inside(p[0], p[1], hole)])  # the twin: rows over the hole

    def test_a_part_scanned_by_a_depth_camera(self):
        self.check(Part("part_scan"), 0.01)


if __name__ == "__main__":
    if not DATA:
        print("SKIPPED: SCAN_TO_PATH_DATA names no directory with the parts' meshes")
        sys.exit(SKIPPED)
    unittest.main()
