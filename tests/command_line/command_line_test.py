#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 scan_to_path developers
# SPDX-License-Identifier: Apache-2.0
"""Drives the executable as a user does: results, determinism, exit statuses, one-line errors, nothing half-written.

usage: command_line_test.py EXECUTABLE SOURCE_DIRECTORY
"""
import hashlib
import json
import os
import pathlib
import pty
import re
import resource
import select
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest

import jsonschema

from executable import EXECUTABLE, SMALL, run, write_plate

SOURCE = pathlib.Path(sys.argv.pop(1)).resolve()
INTERRUPTED = "scan_to_path: interrupted; nothing was written\r\n"


def no_room():
    """In the child: writing more than 20 kB fails, as on a full disk."""
    resource.setrlimit(resource.RLIMIT_FSIZE, (20000, 20000))
    signal.signal(signal.SIGXFSZ, signal.SIG_IGN)


def interrupted_at(stage, *arguments):
    """Exit status and last line on the terminal of a run that gets SIGINT as soon as its progress shows `stage`."""
    terminal, child_end = pty.openpty()
    child = subprocess.Popen([str(EXECUTABLE), *map(str, arguments)], stdout=subprocess.DEVNULL, stderr=child_end)
    os.close(child_end)
    shown, sent, end = "", False, time.monotonic() + 60
    while time.monotonic() < end and select.select([terminal], [], [], end - time.monotonic())[0]:
        try:
            shown += os.read(terminal, 4096).decode()
        except OSError:  # the child has closed its end
            break
        if not sent and re.search(stage + r" *\[[#.]{40}\]", shown):
            child.send_signal(signal.SIGINT)
            sent = True
    os.close(terminal)
    status = child.wait(timeout=30)
    assert sent, f"no progress of {stage} in {shown!r}"
    return status, shown.rsplit("\x1b[K", 1)[-1]


def digests(directory):
    return {path.name: hashlib.sha256(path.read_bytes()).hexdigest() for path in sorted(directory.iterdir())
            if path.name != "timing.json"}


class CommandLine(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.root = pathlib.Path(tempfile.mkdtemp(prefix="scan_to_path_"))
        cls.log = cls.root / "samples.csv"
        done = run("emulate", "--errors", "realistic", *SMALL, "--out", cls.log)
        assert done.returncode == 0, done.stderr

    @classmethod
    def tearDownClass(cls):
        shutil.rmtree(cls.root)

    def plan(self, *arguments, input=None, out="out", **keywords):
        return run("plan", "--input", input or self.log, "--out", self.root / out, *arguments, **keywords)

    def assert_refused(self, done, *parts, status=2, out="out"):
        self.assertEqual(done.returncode, status, done.stderr)
        self.assertEqual(done.stderr.count("\n"), 1, done.stderr)
        for part in parts:
            self.assertIn(part, done.stderr)
        self.assertFalse((self.root / (out + ".part")).exists())

    # What comes out

    def test_report_follows_its_schema(self):
        self.assertEqual(self.plan(out="schema").returncode, 0)
        report = json.loads((self.root / "schema/report.json").read_text())
        self.assertFalse([note for note in report["notes"] if "a plane around the rest" in note])  # the S part's is gone
        schema = json.loads((SOURCE / "docs/report.schema.json").read_text())
        jsonschema.validate(report, schema)
        del report["stages"][0]["in"]
        with self.assertRaises(jsonschema.ValidationError):
            jsonschema.validate(report, schema)

    def test_same_bytes_twice_and_with_any_number_of_threads(self):
        for number, threads in enumerate(("1", "1", "2", "3")):
            self.assertEqual(self.plan("--threads", threads, out=f"same_{number}").returncode, 0)
        first = digests(self.root / "same_0")
        self.assertIn("program.mod", first)
        for number in (1, 2, 3):
            self.assertEqual(digests(self.root / f"same_{number}"), first)

    def test_emulation_is_seeded(self):
        names = [self.root / f"seed_{number}.csv" for number in range(3)]
        for name, seed, threads in zip(names, ("7", "7", "8"), ("1", "2", "1")):
            done = run("emulate", "--errors", "realistic", "--seed", seed, "--threads", threads, *SMALL, "--out", name)
            self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(names[0].read_bytes(), names[1].read_bytes())
        self.assertNotEqual(names[0].read_bytes(), names[2].read_bytes())

    def test_set_wins_over_an_error_set(self):
        done = run("emulate", "--errors", "realistic", "--set", "emulate.errors.spike_rate=0.125", "--print-config")
        self.assertIn("spike_rate: 0.125", done.stdout)
        self.assertIn("noise_sigma: 2e-06", done.stdout)

    def test_an_explicit_raster_height_wins_over_the_parts(self):
        part = write_plate(self.root / "plate.off", 0.1, size=(0.05, 0.02))
        pose = ["--workpiece-pose", "0.85 -0.08 0.35 0 0 0"]

        def height(*flags):
            printed = run("emulate", "--workpiece", part, "--print-config", *flags).stdout
            return float(re.search(r"\n +height: (\S+)  # \[m\] of the sensor above", printed).group(1))

        # The plate lies at 0.1 m; the middle of the laser's range of 55 to 105 mm is 80 mm.
        self.assertAlmostEqual(height(), 0.180, places=12)
        default = float(re.search(r"\n +height: (\S+)  # \[m\] of the sensor above",
                                  run("emulate", "--print-config").stdout).group(1))
        explicit = ["--set", f"emulate.raster.height={default}"]
        self.assertEqual(height(*explicit), default)
        config = self.root / "height.yaml"
        config.write_text(f"emulate: {{raster: {{height: {default}}}}}\n")
        self.assertEqual(height("--config", config), default)
        scan = ["emulate", "--workpiece", part, *pose, *SMALL, "--set", "emulate.raster.pitch=0.005", "--out",
                self.root / "plate.csv"]
        self.assertIn("nearest 80.0 mm", run(*scan).stdout)
        # 20 mm below the plate.
        self.assert_refused(run(*scan, *explicit), f"emulate.raster.height is {default:.6f} m, must be at least 0.105000 m")

    def test_printed_configuration_reads_back_as_itself(self):
        printed = run("plan", "--print-config", "--set", "path.lead=0.125").stdout
        self.assertIn("lead: 0.125", printed)
        config = self.root / "printed.yaml"
        config.write_text(printed)
        self.assertEqual(run("plan", "--print-config", "--config", config).stdout, printed)

    def test_set_wins_over_file_wins_over_default(self):
        config = self.root / "some.yaml"
        config.write_text("path: {lead: 0.25, tilt: 0.125}\n")
        printed = run("plan", "--print-config", "--config", config, "--set", "path.lead=0.5").stdout
        self.assertIn("lead: 0.5 ", printed)
        self.assertIn("tilt: 0.125", printed)

    def test_part_and_path_move_together(self):
        log = self.root / "moved.csv"
        pose = "0.9 0.05 0.4 0 0 0"
        self.assertEqual(run("emulate", *SMALL, "--workpiece-pose", pose, "--out", log).returncode, 0)
        done = self.plan("--workpiece-pose", pose, "--reference", "s_part", "--stop-after", "path", input=log, out="moved")
        self.assertEqual(done.returncode, 0, done.stderr)
        accuracy = json.loads((self.root / "moved/report.json").read_text())["accuracy"]
        # Rows 20 mm apart: the surface between them is known to tenths of a millimetre only.
        self.assertLess(accuracy["reference_path_rms"]["value"], 2e-4)

    def test_quiet_prints_nothing(self):
        done = self.plan("--quiet", "--stop-after", "fit", out="quiet")
        self.assertEqual((done.returncode, done.stdout, done.stderr), (0, "", ""))

    def test_help_and_version(self):
        self.assertIn("--scallop", run("plan", "--print-config").stdout.replace("scallop_height", "--scallop"))
        for arguments in (["--help"], ["plan", "--help"], ["emulate", "--help"]):
            done = run(*arguments)
            self.assertEqual(done.returncode, 0)
            self.assertIn("--help", done.stdout)
        version = run("--version").stdout.split()[-1]
        self.assertIn(f"<version>{version}</version>", (SOURCE / "package.xml").read_text())

    # What is refused

    def lines(self):
        return self.log.read_text().splitlines()

    def refused_log(self, lines, *parts):
        broken = self.root / "broken.csv"
        broken.write_text("\n".join(lines) + "\n")
        self.assert_refused(self.plan(input=broken), *parts)

    def test_broken_logs(self):
        lines = self.lines()
        cells = lines[100].split(",")
        at = lambda row: lines[:100] + [row] + lines[101:]
        self.refused_log([], "broken.csv")
        self.refused_log(lines[:2], "broken.csv")
        self.refused_log(lines[:100] + [lines[100][:20]], "line 101")
        self.refused_log(at(",".join(cells[:1] + ["nan"] + cells[2:])), "line 101")
        self.refused_log(at(",".join(cells[:-1] + ["inf"])), "line 101")
        self.refused_log(at(",".join(["0.001"] + cells[1:])), "line 101")
        self.refused_log(at(",".join(cells[:1] + ["x"] + cells[2:])), "line 101")
        self.refused_log(at(",".join(cells[:2])), "line 101")
        self.refused_log(lines[:1] + [lines[1].replace("joint_3", "joint_9")] + lines[2:], "joint_")

    def test_files_that_are_not_there_or_not_inputs(self):
        self.assert_refused(self.plan(input=self.root / "none.csv"), "cannot read", "none.csv")
        self.assert_refused(self.plan(input=self.root), "is a directory")
        noise = self.root / "noise.bin"
        noise.write_bytes(bytes(range(256)) * 10)
        self.assert_refused(self.plan(input=noise), "noise.bin", "none of")
        mesh = self.root / "part.off"
        mesh.write_text("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n")
        self.assert_refused(self.plan(input=mesh), "emulate --workpiece part.off")
        self.assert_refused(run("emulate", "--workpiece", noise, "--out", self.root / "x.csv"), "noise.bin")
        mesh.write_text("OFF\n3 1 0\n0 0 0\n240 0 0\n0 160 0\n3 0 1 2\n")
        self.assert_refused(run("emulate", "--workpiece", mesh, "--out", self.root / "x.csv"), "--units mm")

    def test_one_line_and_lines_of_two_points(self):
        cloud = self.root / "cloud.ply"

        def refused(points, *parts):
            header = "ply\nformat ascii 1.0\nelement vertex %d\nproperty float x\nproperty float y\nproperty float z\nend_header\n"
            cloud.write_text(header % len(points) + "".join("%.6f %.6f %.6f\n" % point for point in points))
            self.assert_refused(self.plan(input=cloud), "cloud.ply" if not parts else parts[0])

        refused([(0.001 * i, 0.0, 0.0) for i in range(200)], "row")
        refused([(0.1 * (i % 2), 0.004 * (i // 2), 0.0) for i in range(40)], "row")
        refused([(0.001 * i if j % 2 else 0.1 - 0.001 * i, 0.004 * j + (0.0002 * i if j == 2 else 0.0), 0.0)
                 for j in range(6) for i in range(100)], "row")

    def test_joints_outside_their_limits(self):
        lines = self.lines()
        cells = lines[2000].split(",")
        cells[2] = str(float(cells[2]) + 1e7)
        self.refused_log(lines[:2000] + [",".join(cells)] + lines[2001:], "joint_2", "must be in")

    def test_bad_robots(self):
        robot = self.root / "arm.urdf"
        text = (SOURCE / "urdf/irb2400.urdf").read_text()
        robot.write_text(text.replace('"tool0"', '"flange"'))
        self.assert_refused(self.plan("--robot", robot), "tool0")
        robot.write_text(text[:1000])
        self.assert_refused(self.plan("--robot", robot), "arm.urdf")
        robot.write_text(text.replace("<robot", '<robot xmlns:xacro="http://www.ros.org/wiki/xacro"', 1)
                         .replace("<link", "<xacro:include filename=\"x\"/><link", 1))
        self.assert_refused(self.plan("--robot", robot), "xacro")
        self.assert_refused(self.plan("--robot", self.root / "none.urdf"), "none.urdf")

    def test_bad_flags_and_configurations(self):
        self.assert_refused(self.plan("--set", "path.ball_radius=-1"), "path.ball_radius is -1 m", "must be in")
        self.assert_refused(self.plan("--set", "path.bal_radius=1"), "did you mean path.ball_radius")
        self.assert_refused(self.plan("--set", "path.ball_radius=wide"), "must be a number [m]")
        self.assert_refused(self.plan("--set", "path.scallop_height=0.03"), "path.scallop_height")
        self.assert_refused(self.plan("--process", "milling"), "milling", "cutting")
        self.assert_refused(self.plan("--stop-after", "never"), "must be one of scan, fit, path, motion, program")
        self.assert_refused(self.plan("--frobnicate"), "--frobnicate")
        self.assert_refused(run("plan"), "--input is missing")
        self.assert_refused(run("plan", "--input", self.log, "--out", ""), "--out", "is empty")
        self.assert_refused(self.plan("--set", "cell.tool.rpy=[0, 0, 45]"), "cell.tool.rpy[2] is 45 rad", "must be in [-7, 7]")
        self.assert_refused(self.plan("--workpiece-pose", "0.9 0 0.4 0 0 90"), "cell.workpiece.rpy[2]", "is 90 rad")
        self.assert_refused(run())
        self.assert_refused(run("emulate", "--errors", "some", "--out", self.root / "x.csv"), "none, white, realistic")
        config = self.root / "bad.yaml"
        config.write_text("path:\n  lead: [1\n")
        self.assert_refused(self.plan("--config", config), "bad.yaml line", "not YAML")

    def test_broken_configurations_give_one_printable_line(self):
        config = self.root / "broken.yaml"
        cases = {b"": "sets nothing", b"\xff\xfe\0": "sets nothing", b"# lead: 1\n": "sets nothing",
                 b"lead\n": "a configuration is sections of keys", b"- lead\n": "a list of 1",
                 b"path: {lead: 1}\npath: {tilt: 1}\n": "line 2: key path stands twice",
                 b"path: {lead: 0.1}\n---\npath: {lead: 0.2}\n": "another document",
                 b"path: {lead: \"\\e[2J\"}\n": "path.lead is '\\x1b[2J'", self.log.read_bytes(): "broken.yaml",
                 bytes(range(256)): "broken.yaml", pathlib.Path(EXECUTABLE).read_bytes(): "broken.yaml"}
        for content, message in cases.items():
            with self.subTest(begin=content[:30]):
                config.write_bytes(content)
                done = self.plan("--config", config)
                self.assert_refused(done, "broken.yaml", message)
                self.assertTrue(done.stderr.rstrip("\n").isprintable() and done.stderr.isascii(), done.stderr[:200])
                self.assertLess(len(done.stderr), 400)

    def test_relief_beyond_the_range_is_said(self):
        done = run("emulate", *SMALL, "--set", "emulate.raster.height=0.115", "--no-table", "--out", self.root / "far.csv")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("out of the sensor's range", done.stdout)
        self.assertIn("second time", done.stdout)

    def emulated_at(self, height, *arguments):
        log = self.root / f"at_{height}.csv"
        done = run("emulate", "--errors", "realistic", *SMALL, "--set", f"emulate.raster.height={height}", *arguments,
                   "--out", log)
        self.assertEqual(done.returncode, 0, done.stderr)
        return log

    def test_half_a_part_is_no_success(self):
        for height, side, way in (("0.12", "too far", "lower"), ("0.056", "too near", "higher"),
                                  ("0.1", "too far", "lower"), ("0.062", "too near", "higher")):
            with self.subTest(height=height):
                out = f"half_{height}"
                done = self.plan(input=self.emulated_at(height), out=out)
                self.assertEqual(done.returncode, 1, done.stdout + done.stderr)
                note = [line for line in done.stdout.splitlines() if "a second time with the sensor " + way in line]
                self.assertEqual(len(note), 1, done.stdout)
                self.assertNotIn(" 0.0 % " + side, note[0].replace("(", " "))
                self.assertIn("FAILED    unseen_share is ", done.stdout)
                self.assertFalse([name for name in os.listdir(self.root / out)
                                  if name.startswith(("program", "pulses", "trajectory"))])

    def test_a_part_out_of_sight_asks_for_another_sweep(self):
        self.assert_refused(self.plan(input=self.emulated_at("0.2"), out="none"), "none of", "no return",
                            "second time with the sensor lower", out="none")
        plate = ["--workpiece", write_plate(self.root / "near.off")]
        self.assert_refused(self.plan(input=self.emulated_at("0.03", *plate), out="none"), "none of", "no return",
                            "second time with the sensor higher", out="none")

    def test_what_must_be_there_is_asked_for_by_name(self):
        self.assert_refused(self.plan("--set", "fit.with_surface=false", "--set", "path.row_source=scan_lines"),
                            "fit.with_surface is false")
        self.assert_refused(self.plan("--set", "path.pitch=1e-7"), "path.pitch of 0.100 um", "at most 10000")

    # What must not be lost

    def test_full_disk_leaves_the_older_result(self):
        self.assertEqual(self.plan(out="full").returncode, 0)
        before = digests(self.root / "full")
        self.assert_refused(self.plan(out="full", preexec_fn=no_room, restore_signals=False), "cannot write", out="full")
        self.assertEqual(digests(self.root / "full"), before)

    def test_failing_waypoints_end_with_status_one_and_no_program(self):
        self.assertEqual(self.plan(out="failing").returncode, 0)
        done = self.plan("--set", "motion.speed_fraction=0.01", "--set", "path.feed=1", out="failing")
        self.assertEqual(done.returncode, 1, done.stdout)
        self.assertIn("FAILED", done.stdout)
        names = set(os.listdir(self.root / "failing"))
        self.assertIn("path.csv", names)
        self.assertFalse([name for name in names if name.startswith("program") or name == "pulses.csv"])

    def test_full_disk_leaves_the_older_log(self):
        log = self.root / "full.csv"
        log.write_text("an older log")
        done = run("emulate", *SMALL, "--out", log, preexec_fn=no_room, restore_signals=False)
        self.assert_refused(done, "cannot write", "full.csv", out="full.csv")
        self.assertEqual(log.read_text(), "an older log")
        self.assertGreater(self.log.stat().st_size, 20000)
        self.assert_refused(run("emulate", *SMALL, "--out", "/dev/full"), "cannot write", "/dev/full")

    def test_interrupt_leaves_nothing(self):
        big = ["--set", "emulate.raster.pitch=0.0002", "--set", "emulate.sample_rate=5000"]
        for stage in ("planning the scan", "scanning"):
            status, last_line = interrupted_at(stage, "emulate", *big, "--out", self.root / "interrupted.csv")
            self.assertEqual((status, last_line), (130, INTERRUPTED), stage)
        self.assertFalse([name for name in os.listdir(self.root) if name.startswith("interrupted")])

    def test_interrupted_plan_leaves_the_older_result(self):
        out = self.root / "plan_interrupted"
        for stage in ("rows", "lines", "motion"):
            status, last_line = interrupted_at(stage, "plan", "--input", self.log, "--out", out)
            self.assertEqual((status, last_line), (130, INTERRUPTED), stage)
            self.assertFalse([name for name in os.listdir(self.root) if name.startswith("plan_interrupted")], stage)
        self.assertEqual(self.plan(out="plan_interrupted").returncode, 0)
        before = digests(out)
        self.assertEqual(interrupted_at("path", "plan", "--input", self.log, "--out", out)[0], 130)
        self.assertEqual(digests(out), before)
        self.assertFalse((self.root / "plan_interrupted.part").exists())


if __name__ == "__main__":
    unittest.main()
