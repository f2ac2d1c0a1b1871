#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 scan_to_path developers
# SPDX-License-Identifier: Apache-2.0
"""Scanned meshes of real parts, from emulation to path, against the meshes themselves (SCAN_TO_PATH_DATA: where they lie).

usage: real_parts_test.py EXECUTABLE SOURCE_DIRECTORY
"""
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

from mesh_oracle import Mesh, SeenRows, ball_centres, is_inside, places, read_ply, uncut_share, worked_moves

SKIPPED = 77
EXECUTABLE, SOURCE = (pathlib.Path(argument).resolve() for argument in sys.argv[1:3])
del sys.argv[1:3]
DATA = os.environ.get("SCAN_TO_PATH_DATA")
LARGEST = 1e-4  # [m] path off the mesh: the bar
UNCUT = 1e-3  # [m] left on the mesh; more was not reached by any row. As `reference_uncut_share` counts


class Part:
    """A part scanned and its path planned with its configuration; everything in the part's own frame."""

    def __init__(self, name, *flags, errors="realistic", scale=1.0, plan_flags=("--stop-after", "path")):
        file = pathlib.Path(DATA, name + ".ply")
        self.mesh = Mesh(*read_ply(file, scale))
        config = SOURCE / "config" / (name + ".yaml")
        with tempfile.TemporaryDirectory(prefix="scan_to_path_") as directory:
            log, out = pathlib.Path(directory, "samples.csv"), pathlib.Path(directory, "out")
            run("emulate", "--config", config, "--errors", errors, "--workpiece", file, *flags, "--out", log)
            run("plan", "--config", config, "--input", log, *plan_flags, "--out", out)
            self.report = json.loads((out / "report.json").read_text())
            text = (out / "path.csv").read_text()
            self.files = {entry.name for entry in out.iterdir()}
        pose = self.report["config"]["cell"]["workpiece"]
        assert pose["rpy"] == [0.0, 0.0, 0.0], "this oracle knows shifted parts only"
        self.origin = pose["xyz"]
        self.moves = list(worked_moves(text, self.origin))
        self.radius = self.report["config"]["path"]["ball_radius"]
        self.reach = 1.5 * self.report["config"]["emulate"]["raster"]["pitch"]  # [m] of a row to both its sides

    def scanned_rows(self):
        """Where rows lie across: every contact on a scan line does, driven or left out."""
        driven = [p[1] for p, _ in (end for move in self.moves for end in move)]
        left_out = [waypoint["y"] - self.origin[1] for waypoint in self.report["left_out"]]
        rows = {}
        for y in driven + left_out:
            rows.setdefault(round(y, 4), []).append(y)
        return sorted(sum(places) / len(places) for places in rows.values())

    def failed_tolerances(self):
        return [name for name, figure in self.report["accuracy"].items() if not figure.get("pass", True)]


def run(*arguments):
    """Status 1 is no failure here: the ball does not fit into these parts' folds, which is said and not cut."""
    done = subprocess.run([EXECUTABLE, *arguments, "--quiet"], check=False, stderr=subprocess.PIPE, text=True)
    assert done.returncode in (0, 1), done.stderr


def uncovered_share(part, moves):
    return uncut_share(part.mesh, moves, part.radius, part.reach, UNCUT)


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
        # The twins: a part that lies elsewhere, and a path without its last tenth.
        self.assertGreater(largest_distance(part.mesh, shifted(part.moves, 2e-4)), LARGEST)
        self.assertGreater(uncovered_share(part, part.moves[: int(0.9 * len(part.moves))]), most_uncovered)

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

    def test_the_ball_of_a_partial_program_keeps_off_what_was_seen(self):
        part = Part("part_scan", errors="none", plan_flags=("--allow-partial",))
        self.assertIn("program.mod", part.files)
        self.assertGreater(len(part.report["left_out"]), 1000)
        pitch = part.report["config"]["emulate"]["raster"]["pitch"]
        rows = part.scanned_rows()
        self.assertLess(max(abs(b - a - pitch) for a, b in zip(rows, rows[1:])), 1e-6)
        seen = SeenRows(part.mesh, rows)
        # What is no gouge yet, the chords of the ball's centre, and the lines' noise (three sigmas of it).
        path = part.report["config"]["path"]
        bound = (path["gouge_tolerance"] + path["chord_tolerance"] +
                 3.0 * part.report["accuracy"]["line_noise"]["value"])
        deepest = max(seen.depth(centre, part.radius) for centre in ball_centres(part.moves, part.radius))
        print(f"{len(part.moves)} worked moves of a partial program, the ball at most {1e6 * deepest:.1f} um in what "
              f"{len(rows)} rows saw, bound {1e6 * bound:.1f} um")
        self.assertLessEqual(deepest, bound)
        # The twin: a check that lets the ball go one gouge_tolerance deeper.
        lower = shifted(part.moves, -path["gouge_tolerance"])
        self.assertTrue(any(seen.depth(centre, part.radius) > bound for centre in ball_centres(lower, part.radius)))


if __name__ == "__main__":
    if not DATA:
        print("SKIPPED: SCAN_TO_PATH_DATA names no directory with the parts' meshes")
        sys.exit(SKIPPED)
    unittest.main()
