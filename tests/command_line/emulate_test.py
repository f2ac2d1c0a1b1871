#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 scan_to_path developers
# SPDX-License-Identifier: Apache-2.0
"""emulate: where the sensor is carried, which errors and seeds it takes, what it says it saw.

usage: emulate_test.py EXECUTABLE
"""
import pathlib
import re
import shutil
import tempfile
import unittest

from executable import SMALL, run, write_plate

POSE = ["--workpiece-pose", "0.85 -0.08 0.35 0 0 0"]


class Emulate(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.root = pathlib.Path(tempfile.mkdtemp(prefix="scan_to_path_"))

    @classmethod
    def tearDownClass(cls):
        shutil.rmtree(cls.root)

    def emulate(self, *arguments):
        return run("emulate", *SMALL, *arguments, "--out", self.root / "samples.csv")

    def assert_refused(self, done, message):
        self.assertEqual((done.returncode, done.stdout), (2, ""), done.stdout)
        self.assertEqual(done.stderr.count("\n"), 1, done.stderr)
        self.assertIn(message, done.stderr)
        self.assertFalse((self.root / "samples.csv").exists())

    # Where the sensor is carried

    def test_a_sensor_in_the_part_is_refused(self):
        ridge = self.root / "ridge.off"  # 200 mm high, along y
        corners = [(x, y, 0.2 if x == 0.025 else 0.0) for x in (0.0, 0.025, 0.05) for y in (0.0, 0.02)]
        faces = [(0, 2, 1), (1, 2, 3), (2, 4, 3), (3, 4, 5)]
        ridge.write_text("OFF\n6 4 0\n" + "".join("%g %g %g\n" % corner for corner in corners) +
                         "".join("3 %d %d %d\n" % face for face in faces))
        part = ["--workpiece", ridge, *POSE, "--set", "emulate.raster.pitch=0.005"]
        # Half way up, 0.1 m, and the middle of the laser's range, 80 mm, over that.
        self.assert_refused(self.emulate(*part), "emulate.raster.height is 0.180000 m, must be at least 0.205000 m")
        self.assert_refused(self.emulate(*part, "--set", "emulate.raster.height=0.2049"), "at least 0.205000 m")
        done = self.emulate(*part, "--set", "emulate.raster.height=0.205")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("too near", done.stdout)

    def test_the_s_part_and_the_table_are_kept_clear_of_too(self):
        # 0.020 + 0.004 - 0.003 m are the S part's highest point.
        self.assert_refused(self.emulate("--set", "emulate.raster.height=0.0259"), "at least 0.026000 m")
        self.assert_refused(self.emulate("--table", "0.1", "--set", "emulate.raster.height=0.1"), "at least 0.105000 m")

    def test_nothing_seen_is_said(self):
        corners = [(0.0, 0.0), (0.001, 0.0), (0.0, 0.001), (0.05, 0.05), (0.049, 0.05), (0.05, 0.049)]
        part = self.root / "specks.off"  # two, in opposite corners: rows 20 mm apart pass them by
        part.write_text("OFF\n6 2 0\n" + "".join("%g %g 0\n" % corner for corner in corners) + "3 0 1 2\n3 3 4 5\n")
        done = self.emulate("--workpiece", part, *POSE)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("range     nothing seen", done.stdout)
        self.assertNotIn("nearest", done.stdout)
        (self.root / "samples.csv").unlink()

    def test_what_was_seen_is_said(self):
        done = self.emulate("--workpiece", write_plate(self.root / "plate.off", 0.1, size=(0.05, 0.02)), *POSE)
        self.assertIn("nearest 80.0 mm, farthest 80.0 mm", done.stdout)
        self.assertNotIn("nothing seen", done.stdout)
        (self.root / "samples.csv").unlink()

    # Errors and seeds

    def printed(self, key, *flags):
        text = run("emulate", "--print-config", *flags).stdout
        return float(re.search(rf"\n +{key}: (\S+)", text).group(1))

    def test_file_wins_over_error_set_and_set_wins_over_file(self):
        config = self.root / "errors.yaml"
        config.write_text("emulate: {errors: {spike_rate: 0.125, noise_sigma: 0}}\n")
        preset = ["--errors", "realistic"]
        of_set = self.printed("spot_diameter", *preset)
        self.assertGreater(of_set, 0.0)
        self.assertEqual(self.printed("spot_diameter", "--config", config, *preset), of_set)
        self.assertEqual(self.printed("spike_rate", "--config", config, *preset), 0.125)
        self.assertEqual(self.printed("noise_sigma", "--config", config, *preset), 0.0)
        assignment = ["--set", "emulate.errors.spike_rate=0.25"]
        self.assertEqual(self.printed("spike_rate", "--config", config, *assignment, *preset), 0.25)

    def test_seeds_are_whole_numbers_from_zero(self):
        for command in (["emulate", "--out", self.root / "samples.csv"],
                        ["plan", "--input", self.root / "samples.csv", "--out", self.root / "out"]):
            for seed in ("-5", "1.5", "2147483648", "x"):
                done = run(*command, "--seed", seed)
                self.assert_refused(done, f"--seed: Value {seed} not in range 0 to 2147483647")

    def test_help_of_plan_says_that_its_seed_changes_nothing(self):
        text = " ".join(run("plan", "--help").stdout.split())
        self.assertIn("cutting draws no random numbers", text)


if __name__ == "__main__":
    unittest.main()
