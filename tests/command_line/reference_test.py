#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 scan_to_path developers
# SPDX-License-Identifier: Apache-2.0
"""plan --reference: what it takes as the true surface, and what it says of a path that is off it.

usage: reference_test.py EXECUTABLE
"""
import json
import pathlib
import shutil
import tempfile
import unittest

from executable import SMALL, run, write_plate


class Reference(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.root = pathlib.Path(tempfile.mkdtemp(prefix="scan_to_path_"))
        cls.plate = write_plate(cls.root / "plate.off")
        cls.log = cls.root / "plate.csv"
        done = run("emulate", "--workpiece", cls.plate, *SMALL, "--out", cls.log)
        assert done.returncode == 0, done.stderr

    @classmethod
    def tearDownClass(cls):
        shutil.rmtree(cls.root)

    def plan(self, *arguments):
        # A plate level to the bit, without noise or a table, measures the same all over, as a sensor that is off does.
        return run("plan", "--input", self.log, "--out", self.root / "out", "--set", "cell.laser.max_repeats=0",
                   *arguments)

    def accuracy(self):
        return json.loads((self.root / "out/report.json").read_text())["accuracy"]

    def test_another_part_fails_the_job(self):
        done = self.plan("--reference", "s_part")
        self.assertEqual(done.returncode, 1, done.stdout + done.stderr)
        figure = self.accuracy()["reference_path_largest"]
        # The S part rises 21 mm over the plate, and nearest points are nearer than what lies straight below.
        self.assertTrue(0.015 < figure["value"] < 0.021, figure)
        self.assertIn("FAILED    reference_path_largest is ", done.stdout)
        names = {path.name for path in (self.root / "out").iterdir()}
        self.assertEqual(names, {"path.csv", "report.json", "timing.json"})

    def test_without_limits_it_is_measured_only(self):
        limits = ("path", "cut", "scallop")
        done = self.plan("--reference", "s_part", *(flag for name in limits
                                                    for flag in ("--set", f"report.max_reference_{name}=0")))
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertTrue((self.root / "out/program.mod").exists())
        self.assertGreater(self.accuracy()["reference_path_largest"]["value"], 0.015)

    def test_the_part_itself_passes_with_stock_too(self):
        for flags in ([], ["--set", "path.stock=2e-3"]):
            done = self.plan("--reference", self.plate, "--stop-after", "path", *flags)
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
            # No errors but the encoders' and the log's digits: below a micrometre.
            self.assertLess(self.accuracy()["reference_path_largest"]["value"], 1e-6)

    def test_a_mesh_in_millimetres_or_inches(self):
        for unit, metres in (("mm", 1e-3), ("inch", 0.0254)):
            mesh = write_plate(self.root / "other.off", unit=metres)
            for flags in (["--reference-units", unit], ["--reference-scale", metres]):
                done = self.plan("--reference", mesh, "--stop-after", "path", *flags)
                self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
                self.assertLess(self.accuracy()["reference_path_largest"]["value"], 1e-6)

    def test_a_mesh_of_no_plausible_size_names_its_own_flag(self):
        mesh = write_plate(self.root / "mm.off", unit=1e-3)
        done = self.plan("--reference", mesh)
        self.assertEqual(done.returncode, 2)
        self.assertIn("if the file is in mm (0.288 m), say --reference-units mm", done.stderr)
        self.assertNotIn("--units", done.stderr)
        for flags, message in ((["--reference-units", "cm"], "--reference-units: value is 'cm', must be one of m, mm, inch"),
                               (["--reference-scale", "-1"], "--reference-scale")):
            done = self.plan("--reference", mesh, *flags)
            self.assertEqual(done.returncode, 2)
            self.assertIn(message, done.stderr)


if __name__ == "__main__":
    unittest.main()
