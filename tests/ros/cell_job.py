#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 scan_to_path developers
# SPDX-License-Identifier: Apache-2.0
"""A job of the whole cell: nothing lost, accurate, in time, the same bytes as the command line, and no look at the truth."""
import json
import pathlib
import subprocess
import sys
import tempfile
import time
import unittest
from xmlrpc.client import ServerProxy

import rosgraph
import rospy
import rostest
from diagnostic_msgs.msg import DiagnosticArray
from scan_to_path.msg import PlannedPath
from std_msgs.msg import Header

import cell

RMS, LARGEST = 12e-6, 45e-6  # [m] path off the true surface, as in the command line's acceptance test
LONGEST = 60.0               # [s] from goal to program
FILES = ("path.csv", "trajectory.csv", "pulses.csv")


def command(*arguments):
    subprocess.run([cell.COMMAND_LINE, *arguments, "--quiet"], check=True, timeout=100)


class CellJob(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory(prefix="scan_to_path_")
        directory = pathlib.Path(cls.temporary.name)
        cls.diagnostics = cell.Listener("/diagnostics", DiagnosticArray)
        cls.finished = cell.Listener("/cell/scan_finished", Header)
        cls.planned = cell.Listener("/cell/planned_path", PlannedPath)
        started = time.monotonic()
        cls.job = cell.Job(directory / "ros")
        cls.exit, cls.said = cls.job.finish(100)
        cls.duration = time.monotonic() - started
        log = directory / "samples.csv"
        command("emulate", "--errors", "realistic", "--seed", "1", "--out", log)
        command("plan", "--input", log, "--out", directory / "samples")
        command("plan", "--input", cls.job.out / "scan.pcd", "--reference", "s_part", "--out", directory / "cloud")
        cls.from_samples, cls.from_cloud = directory / "samples", directory / "cloud"

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    def test_the_job_succeeds_in_time(self):
        self.assertEqual(self.exit, 0, self.said)
        print(f"whole graph, S part at 4 mm: {self.duration:.1f} s")
        self.assertLess(self.duration, LONGEST)

    def test_no_sample_is_lost(self):
        stages = {stage["name"]: stage for stage in self.job.report()["stages"]}
        there = {stage["name"]: stage for stage in json.loads((self.from_samples / "report.json").read_text())["stages"]}
        self.assertGreater(there["scan"]["in"], 20000)
        self.assertEqual(stages["scan"], there["scan"])
        self.assertEqual(set(stages["scan"]["dropped"]), {"no return"})  # what lies beside the part

    def test_files_are_the_command_lines(self):
        for name in FILES:
            ours = (self.job.out / name).read_bytes()
            self.assertGreater(len(ours), 10000)
            self.assertEqual(ours, (self.from_samples / name).read_bytes(), name + " from the same samples")
            self.assertEqual(ours, (self.from_cloud / name).read_bytes(), name + " from scan.pcd")

    def test_lowered_feeds_are_the_command_lines(self):
        with tempfile.TemporaryDirectory(prefix="scan_to_path_") as name:
            directory = pathlib.Path(name)
            fast = directory / "fast.yaml"
            fast.write_text(cell.QUICK + "path: {feed: 0.05}\nmotion: {speed_fraction: 0.1}\n")
            job = cell.Job(directory / "ros", fast.read_text())
            status, said = job.finish()
            self.assertEqual(status, 0, said)
            command("plan", "--config", fast, "--input", job.out / "scan.pcd", "--out", directory / "cloud")
            self.assertGreater(job.report()["accuracy"]["feed_lowered"]["value"], 1000)
            for file in (*FILES, "program.mod", "program_2.mod"):
                self.assertEqual((job.out / file).read_bytes(), (directory / "cloud" / file).read_bytes(), file)

    def test_the_path_lies_on_the_true_surface(self):
        figures = json.loads((self.from_cloud / "report.json").read_text())["accuracy"]
        rms, largest = figures["reference_path_rms"]["value"], figures["reference_path_largest"]["value"]
        print(f"path off the true surface: RMS {1e6 * rms:.2f} um, largest {1e6 * largest:.2f} um")
        self.assertLessEqual(rms, RMS)
        self.assertLessEqual(largest, LARGEST)

    def test_the_path_is_ready_soon_after_the_last_sample(self):
        last, _ = self.finished.find()
        ready, _ = self.planned.find()
        print(f"path ready {ready - last:.3f} s after the last sample")
        self.assertLess(ready - last, 1.0)
        self.assertIn("path ready", self.said)

    def test_nobody_looks_at_the_truth(self):
        master = rosgraph.Master(rospy.get_name())

        def lookers():
            publishers, subscribers, _ = master.getSystemState()
            self.assertTrue([topic for topic, _ in publishers if "/truth/" in topic])
            return {node for topic, nodes in subscribers if "/truth" in topic for node in nodes}

        self.assertEqual(lookers(), set())
        self.addCleanup(rospy.Subscriber("/cell/point_laser_emulator/truth/surface", rospy.AnyMsg).unregister)
        self.assertEqual(lookers(), {rospy.get_name()})  # so it would have been seen

    def test_clouds_go_through_the_manager_as_pointers(self):
        manager = ServerProxy(rosgraph.Master(rospy.get_name()).lookupNode("/cell/manager"))
        _, _, connections = manager.getBusInfo(rospy.get_name())
        inside = [(topic, transport) for _, peer, _, transport, topic, *_ in connections
                  if topic in ("/cell/scan_cloud", "/cell/scan_info", "/cell/fitted_scan", "/cell/planned_path")
                  and peer in ("/cell/manager", manager_uri(manager))]
        self.assertTrue({topic for topic, _ in inside} >= {"/cell/scan_cloud", "/cell/fitted_scan"}, connections)
        self.assertEqual({transport for _, transport in inside}, {"INTRAPROCESS"}, inside)

    def test_every_stage_has_diagnostics(self):
        for stage in ("scan", "fit", "path", "motion"):
            def says(message, name="/cell/" + stage):
                return any(status.name == name and status.level == 0 and
                           {"jobs": "1"}.items() <= {v.key: v.value for v in status.values}.items()
                           for status in message.status)
            cell.wait_until(lambda: self.diagnostics.find(says), 5.0, "diagnostics of " + stage)


def manager_uri(manager):
    return manager._ServerProxy__host


if __name__ == "__main__":
    rospy.init_node("cell_job")
    rostest.rosrun("scan_to_path", "cell_job", CellJob, sys.argv)
