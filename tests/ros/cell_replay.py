#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 scan_to_path developers
# SPDX-License-Identifier: Apache-2.0
"""A recorded scan gives the live run's program, byte for byte; a broken recording gives one line; the program played
back stays on the path."""
import pathlib
import struct
import subprocess
import sys
import tempfile
import unittest

import genpy
import rospy
import rostest
from diagnostic_msgs.msg import DiagnosticArray
from scan_to_path.msg import PlaybackDeviation
from sensor_msgs.msg import JointState
from std_msgs.msg import Empty

import cell

POSITION, ANGLE = 1e-6, 1.745e-5  # [m], [rad] = 0.001 deg: the tool off the path at waypoints
FILES = ("scan.pcd", "path.csv", "trajectory.csv", "pulses.csv", "program.mod")
BAG = pathlib.Path(sys.argv[1])


class TriggerResponse(genpy.Message):
    __slots__ = ["success", "message"]
    _slot_types = ["bool", "string"]

    def deserialize(self, data):
        self.success, length = struct.unpack_from("<?I", data)
        self.message = data[5:5 + length].decode()
        return self


class Trigger:
    """std_srvs/Trigger, whose Python half the package does not need otherwise."""
    _type, _md5sum = "std_srvs/Trigger", "937c9679a518e3a18d831e57125ea522"
    _request_class, _response_class = Empty, TriggerResponse


def run_job(out, *arguments, configuration=cell.QUICK):
    file = out.with_suffix(".yaml")
    file.write_text(configuration)
    return subprocess.run([cell.RUN_JOB, "--out", out, "--config", file, "--wait", "40", *arguments],
                          capture_output=True, text=True, timeout=60, check=False)


def of_playback(message):
    return next((status for status in message.status if "trajectory_player: playback" in status.name), None)


def is_at_the_end(message):
    status = of_playback(message)
    return status is not None and status.message == "at the end"


class CellReplay(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory(prefix="scan_to_path_")
        cls.directory = pathlib.Path(cls.temporary.name)
        cls.joints = cell.Listener("/cell/joint_states", JointState)
        cell.wait_until(cls.joints.find, 20.0, "the robot before any scan")
        cls.joints.close()
        cls.diagnostics = cell.Listener("/diagnostics", DiagnosticArray)
        cls.deviation = cell.Listener("/cell/playback_deviation", PlaybackDeviation)
        cls.live = run_job(cls.directory / "live", "--play")
        if cls.live.returncode == 0:  # the next job stops the player
            cell.wait_until(lambda: cls.diagnostics.find(is_at_the_end), 5.0, "diagnostics of the playback")
        stop = rospy.ServiceProxy("/cell/scan_recorder/stop", Trigger)
        cls.stopped, cls.stopped_again = stop(), stop()

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()
        BAG.unlink()

    def test_the_played_back_tool_stays_on_the_path(self):
        self.assertEqual(self.live.returncode, 0, self.live.stderr)
        self.assertIn("played back", self.live.stdout)
        _, last = self.deviation.find(lambda message: message.finished)
        rows = [line for line in (self.directory / "live/path.csv").read_text().splitlines() if line[:1] != "#"]
        self.assertEqual(last.waypoints, len(rows) - 1)
        self.assertEqual(last.missing, 0)
        print(f"played back off the path by {1e9 * last.position_largest:.3f} nm, {last.angle_largest:.2e} rad")
        self.assertGreater(last.position_largest, 0.0)
        self.assertLessEqual(last.position_largest, POSITION)
        self.assertLessEqual(last.angle_largest, ANGLE)

    def test_diagnostics_say_how_the_playback_went(self):
        _, last = self.deviation.find(lambda message: message.finished)
        status = of_playback(self.diagnostics.find(is_at_the_end)[1])
        values = {value.key: value.value for value in status.values}
        self.assertEqual(status.level, 0)
        self.assertEqual((values["waypoints"], values["waypoints without a transform"]), (str(last.waypoints), "0"))

    def test_a_recording_stops_once(self):
        self.assertEqual((self.stopped.success, self.stopped.message), (True, str(BAG)))
        self.assertEqual((self.stopped_again.success, self.stopped_again.message), (False, "nothing is recorded any more"))

    def test_a_replay_gives_the_same_program(self):
        # A scan would have other rows: what comes out is the recording's.
        replay = run_job(self.directory / "replay", "--bag", BAG, configuration=cell.QUICK.replace("0.012", "0.02"))
        self.assertEqual(replay.returncode, 0, replay.stderr)
        for name in FILES:
            self.assertEqual((self.directory / "live" / name).read_bytes(), (self.directory / "replay" / name).read_bytes(), name)

    def test_a_broken_bag_is_refused_in_one_line(self):
        whole = BAG.read_bytes()
        for name, content in (("cut", whole[:len(whole) // 2]), ("no_bag", b"t,voltage\n"), ("empty", b"")):
            bag = self.directory / (name + ".bag")
            bag.write_bytes(content)
            refused = run_job(self.directory / name, "--bag", bag)
            self.assertEqual(refused.returncode, 2, name)
            self.assertEqual(len(refused.stderr.strip().splitlines()), 1, refused.stderr)
            self.assertIn(bag.name + ": not a whole bag", refused.stderr)
            self.assertFalse((self.directory / name).exists())
        missing = run_job(self.directory / "missing", "--bag", self.directory / "missing.bag")
        self.assertEqual(missing.returncode, 2)


if __name__ == "__main__":
    rospy.init_node("cell_replay")
    rostest.rosrun("scan_to_path", "cell_replay", CellReplay, sys.argv)
