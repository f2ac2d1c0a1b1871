#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 scan_to_path developers
# SPDX-License-Identifier: Apache-2.0
"""Meshes that are not ours, scanned and planned in the cell: rows keep to the part and out of its holes, and what no
row reaches is named. A wavy mesh with a hole is made here; SCAN_TO_PATH_DATA and Debian's occt-misc bring others."""
import math
import os
import pathlib
import sys
import tempfile
import unittest

import rospy
import rostest

import cell

sys.path.append(str(pathlib.Path(__file__).resolve().parents[1] / "command_line"))
from mesh_oracle import Mesh, is_inside, places, read_ascii_stl, read_ply, uncut_share, worked_moves  # noqa: E402

MESH = pathlib.Path(sys.argv[1])
PROPELLER = pathlib.Path("/usr/share/opencascade/data/stl/propeller.stl")
DATA = os.environ.get("SCAN_TO_PATH_DATA")
LARGEST = 1e-4  # [m] path off the mesh: the bar of real parts
SIZE, HOLE, STEP = 0.1, 0.0125, 0.001  # [m] of the mesh, of its hole's radius, of its grid
RADIUS, SCALLOP, SKIPPED = 0.01, 1e-4, 10
GRID = 5e-4  # [m] of the looks at what is not covered
CONFIGURATION = f"""
path: {{ball_radius: {RADIUS}, scallop_height: {SCALLOP}}}
emulate: {{raster: {{speed: 0.2}}}}
report: {{max_unseen_share: 0.3}}
"""


def wavy_mesh():
    """3 mm to and fro over 50 mm: hollows of 21 mm, slopes of 21 degrees. Triangles sag by 6 um."""
    count = round(SIZE / STEP)
    wave = 2.0 * math.pi / 0.05
    vertices = [(i * STEP, j * STEP, 0.003 * math.sin(wave * i * STEP) * math.cos(0.5 * wave * j * STEP))
                for j in range(count + 1) for i in range(count + 1)]
    triangles = []
    for j in range(count):
        for i in range(count):
            if math.dist(((i + 0.5) * STEP, (j + 0.5) * STEP), (0.5 * SIZE, 0.5 * SIZE)) < HOLE:
                continue
            at = j * (count + 1) + i
            triangles += [(at, at + 1, at + count + 2), (at, at + count + 2, at + count + 1)]
    return vertices, triangles


def format_off(vertices, triangles):
    lines = ["OFF", f"{len(vertices)} {len(triangles)} 0"]
    lines += ["%.9g %.9g %.9g" % vertex for vertex in vertices]
    lines += ["3 %d %d %d" % triangle for triangle in triangles]
    return "\n".join(lines) + "\n"


def moves_of(job):
    report = job.report()
    pose = report["config"]["cell"]["workpiece"]
    return list(worked_moves((job.out / "path.csv").read_text(), pose["xyz"]))


def box_rows(mesh):
    """Moves over all of a mesh's box."""
    low, high = ([end(v[k] for v in mesh.vertices) for k in range(2)] for end in (min, max))
    return [tuple(((x, y, 0.0), (0.0, 0.0, 1.0)) for x in (low[0], high[0]))
            for y in (low[1] + 0.05 * k * (high[1] - low[1]) for k in range(1, 20))]


class CellMesh(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory(prefix="scan_to_path_")
        self.addCleanup(temporary.cleanup)
        self.directory = pathlib.Path(temporary.name)

    def plan(self, name, configuration, *statuses):
        job = cell.Job(self.directory / name, configuration)
        status, said = job.finish(60)
        self.assertIn(status, statuses, said)
        return job, said

    @staticmethod
    def uncovered(mesh, job):
        """As the job has it, and as the mesh does."""
        return (job.report()["accuracy"]["path_uncovered_share"]["value"],
                uncut_share(mesh, moves_of(job), RADIUS, 0.006, 1.05 * SCALLOP, GRID))

    def check(self, mesh, moves):
        """Close to the mesh, and out of its holes."""
        largest = max(mesh.distance(p) for p in places(moves))
        print(f"{len(moves)} worked moves, largest {1e6 * largest:.1f} um off the mesh")
        self.assertLessEqual(largest, LARGEST)
        holes = mesh.holes()
        self.assertEqual(len(holes), 1)
        self.assertFalse([p for p in places(moves) if is_inside(p[0], p[1], holes[0])])
        beside = [p for p in places(moves) if abs(p[0] - 0.5 * SIZE) < 2.0 * HOLE and abs(p[1] - 0.5 * SIZE) < HOLE]
        self.assertTrue(beside)  # rows go up to the hole: it is not just left away

    def test_a_wavy_mesh_with_a_hole(self):
        mesh = Mesh(*wavy_mesh())
        MESH.write_text(format_off(mesh.vertices, mesh.triangles))
        self.addCleanup(MESH.unlink)
        job, said = self.plan("wavy", CONFIGURATION, 0)
        moves = moves_of(job)
        self.check(mesh, moves)
        whole_share, whole_oracle = self.uncovered(mesh, job)
        self.assertLess(whole_share, 0.005)
        self.assertNotIn("are skipped", said)

        skipping = CONFIGURATION.replace("path: {", f'path: {{skip_rows: "{SKIPPED}", ')
        job, said = self.plan("skipped", skipping, 0)
        share, oracle = self.uncovered(mesh, job)
        # What noise makes of cusps that are as high as they may be is there with and without the row.
        print(f"row {SKIPPED} skipped: {100 * share:.2f} % not covered, by the mesh {100 * (oracle - whole_oracle):.2f} %")
        self.assertGreater(oracle - whole_oracle, 0.02)  # a strip of more than 2 mm
        self.assertAlmostEqual(share - whole_share, oracle - whole_oracle, delta=GRID / SIZE)  # a line of it
        self.assertIn("uncovered ", said)
        self.assertIn(f"rows {SKIPPED} are skipped", said)

    @unittest.skipUnless(DATA, "SCAN_TO_PATH_DATA names no directory with the parts' meshes")
    def test_the_wavy_mesh_of_others(self):
        scale = SIZE / 10.5
        file = pathlib.Path(DATA, "wavy_mesh_with_hole.ply")
        self.scan(file, scale)
        configuration = (pathlib.Path(__file__).resolve().parents[2] / "config/wavy_mesh_with_hole.yaml").read_text()
        job, _ = self.plan("others", configuration.replace("raster:\n", "raster:\n    speed: 0.2\n"), 0, 1)
        self.check(Mesh(*read_ply(file, scale)), moves_of(job))
        self.assertIn("path_uncovered_share", job.report()["accuracy"])

    @unittest.skipUnless(PROPELLER.is_file(), "Debian's occt-misc is not installed")
    def test_a_propeller(self):
        scale = 2.5e-4  # 0.24 m wide
        self.scan(PROPELLER, scale)
        configuration = "emulate: {raster: {pitch: 0.004, speed: 0.2}}\nreport: {max_unseen_share: 1}\n"
        job, said = self.plan("propeller", configuration, 1)
        mesh, moves = Mesh(*read_ascii_stl(PROPELLER, scale)), moves_of(job)
        self.assertGreater(len(moves), 3000)
        self.assertFalse([p for p in places(moves) if mesh.top(p[0], p[1]) is None])  # between the blades
        self.assertTrue([p for p in places(box_rows(mesh)) if mesh.top(p[0], p[1]) is None])  # the twin
        share = job.report()["accuracy"]["path_uncovered_share"]["value"]
        print(f"propeller: {len(moves)} worked moves, {100 * share:.2f} % not covered")
        self.assertIn("uncovered ", said)
        self.assertIn("FAILED", said)
        self.assertFalse((job.out / "program.mod").exists())

    def scan(self, file, scale):
        emulator = "/cell/point_laser_emulator/"
        before = {name: rospy.get_param(emulator + name, "") for name in ("workpiece", "workpiece_units")}
        rospy.set_param(emulator + "workpiece", str(file))
        rospy.set_param(emulator + "workpiece_scale", scale)
        self.addCleanup(rospy.delete_param, emulator + "workpiece_scale")
        for name, value in before.items():
            self.addCleanup(rospy.set_param, emulator + name, value)


if __name__ == "__main__":
    rospy.init_node("cell_mesh")
    rostest.rosrun("scan_to_path", "cell_mesh", CellMesh, sys.argv)
