#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 scan_to_path developers
# SPDX-License-Identifier: Apache-2.0
"""What goes wrong in a cell ends in an exit status and a line that says what, leaves nothing half-written, and the
next job works."""
import pathlib
import subprocess
import sys
import tempfile
import time
import unittest

import rospy
import rostest
from actionlib_msgs.msg import GoalID
from diagnostic_msgs.msg import DiagnosticArray
from scan_to_path.msg import RunJobActionFeedback, ScanSamples
from sensor_msgs.msg import JointState
from std_msgs.msg import Header

import cell

NAN = float("nan")


def unload(name):
    subprocess.run(["rosrun", "nodelet", "nodelet", "unload", "/cell/" + name, "/cell/manager"], check=True, timeout=20,
                   stdout=subprocess.DEVNULL)


class Loaded:
    """A nodelet put back into the cell; stays until the test's end."""

    def __init__(self, name):
        self.process = subprocess.Popen(["rosrun", "nodelet", "nodelet", "load", "scan_to_path/" + name, "/cell/manager",
                                         "__name:=" + name, "__ns:=/cell", "tf:=tf", "/tf:=tf", "/tf_static:=tf_static"],
                                        stdout=subprocess.DEVNULL)

    def remove(self):
        self.process.terminate()
        self.process.wait(10)


class CellFaults(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory(prefix="scan_to_path_")
        cls.directory = pathlib.Path(cls.temporary.name)
        cls.feedback = cell.Listener("/cell/job_server/run/feedback", RunJobActionFeedback)
        cls.acknowledged = cell.Listener("/cell/scan_acknowledged", Header)
        cls.diagnostics = cell.Listener("/diagnostics", DiagnosticArray)
        cls.send_samples = rospy.Publisher("/cell/scan_samples", ScanSamples, queue_size=10)
        cls.send_joints = rospy.Publisher("/cell/joint_states", JointState, queue_size=10)
        cls.send_cancel = rospy.Publisher("/cell/job_server/run/cancel", GoalID, queue_size=10)
        cls.standing = rospy.wait_for_message("/cell/joint_states", JointState, 40)
        cls.first = cls.job_of(cls, "first")
        cls.first_exit, cls.first_said = cls.first.finish()
        cls.loaded = []

    @classmethod
    def tearDownClass(cls):
        for nodelet in cls.loaded:
            nodelet.remove()
        cls.temporary.cleanup()

    def job_of(self, name, configuration=cell.QUICK):
        return cell.Job(self.directory / name, configuration)

    def setUp(self):
        for listener in (self.feedback, self.acknowledged, self.diagnostics):
            listener.clear()

    def tearDown(self):
        """Whatever happened, the next job does what the first did, to the byte."""
        job = self.job_of("next_" + self._testMethodName)
        code, said = job.finish()
        self.assertEqual(code, 0, said)
        for name in ("path.csv", "trajectory.csv", "pulses.csv", "scan.pcd"):
            self.assertEqual((job.out / name).read_bytes(), (self.first.out / name).read_bytes(), name)

    def expect_refused(self, job, *parts):
        code, said = job.finish()
        self.assertEqual(code, 2, said)
        for part in parts:
            self.assertIn(part, said)
        self.assertEqual(said.strip().count("\n"), 0, said)
        self.assertTrue(job.left_nothing())

    def wait_for_samples(self):
        """The scan of the job under way has begun."""
        cell.wait_until(lambda: len(self.acknowledged.messages) > 20, 20.0, "samples")

    def reading(self, ahead):
        """Joint states of the robot before it scans, stamped `ahead` of now [s]."""
        reading = JointState(name=self.standing.name, position=list(self.standing.position))
        reading.header.stamp = rospy.Time.now() + rospy.Duration(ahead)
        return reading

    @staticmethod
    def points(job):
        """The scan's points with their times, as many bytes each as the file says."""
        header, data = (job.out / "scan.pcd").read_bytes().split(b"DATA binary\n", 1)
        sizes = next(line for line in header.split(b"\n") if line.startswith(b"SIZE")).split()[1:]
        size = sum(map(int, sizes))
        return {data[i:i + size] for i in range(0, len(data), size)}

    def dropped(self, job):
        return next(stage for stage in job.report()["stages"] if stage["name"] == "scan")["dropped"]

    def test_the_quick_job_works(self):
        self.assertEqual(self.first_exit, 0, self.first_said)

    def test_a_second_job_is_rejected_and_the_first_can_be_cancelled(self):
        first = self.job_of("running", "")
        self.wait_for_samples()
        self.expect_refused(self.job_of("second"), "a job is running; one at a time")
        first.interrupt()
        code, said = first.finish(10)
        self.assertEqual((code, said.strip()), (130, "cancelled"))
        self.assertTrue(first.left_nothing())

    def test_cancelled_in_every_stage(self):
        for stage in ("scan", "fit", "path", "motion"):
            with self.subTest(stage=stage):
                self.feedback.clear()
                job = self.job_of("cancelled_in_" + stage)
                cell.wait_until(lambda: self.feedback.find(lambda at, stage=stage: at.feedback.stage == stage), 20.0, stage)
                self.send_cancel.publish(GoalID())
                code, said = job.finish(10)
                self.assertEqual((code, said.strip()), (130, "cancelled"))
                self.assertTrue(job.left_nothing())

    def test_a_result_that_cannot_be_written(self):
        (self.directory / "file").write_text("in the way")
        for out in (self.directory / "file" / "out", pathlib.Path("/dev/full/out"), pathlib.Path("/proc/out")):
            with self.subTest(out=out):
                job = cell.Job(out, cell.QUICK)
                code, said = job.finish()
                self.assertEqual(code, 2, said)
                self.assertIn(str(out.parent), said)
        self.assertEqual((self.directory / "file").read_text(), "in the way")

    def test_a_configuration_that_is_none(self):
        self.expect_refused(self.job_of("unknown", "path: {leed: 0.01}"), "unknown key path.leed, did you mean path.feed?")
        self.expect_refused(self.job_of("range", "scan: {placement: {max_joint_gap: -1}}"), "scan.placement.max_joint_gap")

    def test_nobody_scans(self):
        rospy.set_param("/cell/emulated", False)  # a real robot's cell, whose robot and sensor are silent
        try:
            self.expect_refused(self.job_of("silent"), "scan: no sample came within 8.0 s")
        finally:
            rospy.set_param("/cell/emulated", True)

    def test_a_clock_that_starts_anew(self):
        now = rospy.Time.now()
        unload("point_laser_emulator")
        self.loaded.append(Loaded("point_laser_emulator"))
        cell.wait_until(lambda: rospy.Time.now() < now, 20.0, "the new emulator's clock")

    def test_joint_states_are_lost_on_the_way(self):
        job = self.job_of("without_tf", "")
        self.wait_for_samples()
        unload("cell_frames")
        self.expect_refused(job, "scan")
        cell.wait_until(lambda: self.diagnostics.find(self.says("/cell/scan", "waiting for transforms")), 5.0, "diagnostics")
        self.loaded.append(Loaded("cell_frames"))

    @staticmethod
    def says(name, key):
        return lambda message: any(status.name == name and any(v.key == key for v in status.values)
                                   for status in message.status)

    def test_messages_that_no_sensor_sends(self):
        job = self.job_of("disturbed")
        self.wait_for_samples()
        foreign = ScanSamples(time_offset=[0.0, 0.001], range=[0.1, 0.1])
        foreign.header.frame_id = "camera"
        foreign.header.stamp = rospy.Time.now()
        self.send_samples.publish(foreign)
        broken = self.reading(0.03)
        broken.position[2] = NAN
        self.send_joints.publish(broken)
        short = self.reading(0.03)
        short.position.pop()
        self.send_joints.publish(short)
        code, said = job.finish()
        self.assertEqual(code, 0, said)
        self.assertEqual(self.dropped(job), {**self.dropped(self.first), "refused": 2})
        self.assertIn("frame_id is 'camera', must be 'sensor'", said)
        self.assertEqual((job.out / "path.csv").read_bytes(), (self.first.out / "path.csv").read_bytes())

    def test_transforms_that_jump(self):
        job = self.job_of("jump")
        self.wait_for_samples()
        for i in range(10):  # half a second; between readings, which come every millisecond
            self.send_joints.publish(self.reading(0.05 * i + 0.0005))
        code, said = job.finish()
        self.assertIn(code, (0, 1), said)  # 1 when more than 5 % had to be left out
        lost = sum(count for reason, count in self.dropped(job).items() if reason != "no return")
        self.assertLess(lost, 1000)
        # Which samples are lost depends on when the jumps come. No point comes from a jump: those that were placed are those that would have been.
        ours, undisturbed = self.points(job), self.points(self.first)
        self.assertEqual(len(ours - undisturbed), 0)
        self.assertEqual(len(undisturbed) - len(ours), lost)

    def test_a_clock_that_goes_back_while_scanning(self):
        job = self.job_of("clock")
        self.wait_for_samples()
        self.send_joints.publish(self.reading(-5.0))
        self.expect_refused(job, "the clock of the transforms went back by ", " s on the way; scan again")

    def test_a_subscriber_that_is_slow(self):
        slow = [rospy.Subscriber(topic, rospy.AnyMsg, lambda _: time.sleep(0.5), queue_size=1, buff_size=1024)
                for topic in ("/cell/scan_points", "/cell/scan_samples", "/cell/scan_acknowledged", "/cell/tf", "/cell/scan_cloud")]
        job = self.job_of("slow")
        code, said = job.finish()
        self.assertEqual(code, 0, said)
        self.assertEqual((job.out / "scan.pcd").read_bytes(), (self.first.out / "scan.pcd").read_bytes())
        for subscriber in slow:
            subscriber.unregister()


if __name__ == "__main__":
    rospy.init_node("cell_faults")
    rostest.rosrun("scan_to_path", "cell_faults", CellFaults, sys.argv)
