#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 scan_to_path developers
# SPDX-License-Identifier: Apache-2.0
"""What goes wrong in a cell ends in an exit status, a line and a diagnostic that say what, leaves nothing half-written,
and the next job works. What a real robot and its sensor do wrong: cell_disturbed.py."""
import contextlib
import pathlib
import resource
import sys
import tempfile
import time
import unittest
from xmlrpc.client import ServerProxy

import rosgraph
import rospy
import rostest
from actionlib_msgs.msg import GoalID
from diagnostic_msgs.msg import DiagnosticArray
from scan_to_path.msg import RunJobActionFeedback, ScanSamples
from sensor_msgs.msg import JointState
from std_msgs.msg import Bool, Header

import cell

NAN = float("nan")
LONG = cell.COARSE.replace("speed: 0.25", "speed: 0.05")  # five times the scan, to do something in the meantime
FINE = cell.COARSE.replace("pitch: 0.015", "pitch: 0.002")  # a path that takes its time
RESULT = ("path.csv", "trajectory.csv", "pulses.csv", "scan.pcd", "program.mod")


class CellFaults(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory(prefix="scan_to_path_")
        cls.directory = pathlib.Path(cls.temporary.name)
        cls.feedback = cell.Listener("/cell/job_server/run/feedback", RunJobActionFeedback)
        cls.acknowledged = cell.Listener("/cell/scan_acknowledged", Header)
        cls.recording = cell.Listener("/cell/scan_recording", Bool)
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

    def job_of(self, name, configuration=cell.COARSE):
        return cell.Job(self.directory / name, configuration)

    def setUp(self):
        self.clear()

    def clear(self):
        for listener in (self.feedback, self.acknowledged, self.recording, self.diagnostics):
            listener.clear()

    def tearDown(self):
        """Whatever happened, the next job does what the first did, to the byte."""
        job = self.job_of("next_" + self._testMethodName)
        code, said = job.finish()
        self.assertEqual(code, 0, said)
        for name in RESULT:
            self.assertEqual((job.out / name).read_bytes(), (self.first.out / name).read_bytes(), name)

    def expect_refused(self, job, *parts):
        """One line that says all parts; of a job that was accepted, the diagnostics say it too. Nothing is written."""
        code, said = job.finish()
        self.assertEqual(code, 2, said)
        for part in parts:
            self.assertIn(part, said)
        self.assertEqual(said.strip().count("\n"), 0, said)
        self.assertTrue(job.left_nothing())
        return said.strip()

    def expect_failed(self, job, *parts):
        said = self.expect_refused(job, *parts)
        self.expect_diagnostic("job_server", lambda status: status.level == 2 and status.message == said)
        self.expect_not_recording()

    def expect_not_recording(self):
        self.assertFalse(self.recording.messages and self.recording.messages[-1][1].data)

    def expect_diagnostic(self, name, condition):
        cell.wait_until(lambda: self.diagnostics.find(lambda message: any(
            name in status.name and condition(status) for status in message.status)), 5.0, "diagnostics of " + name)

    def wait_for_samples(self):
        """The scan of the job under way has begun."""
        cell.wait_until(lambda: self.recording.find(lambda message: message.data), 20.0, "the scan")
        self.acknowledged.clear()  # what came late of the job before
        cell.wait_until(self.acknowledged.find, 20.0, "samples")

    def reading(self, ahead):
        """Joint states of the robot before it scans, stamped `ahead` of now [s]."""
        reading = JointState(name=self.standing.name, position=list(self.standing.position))
        reading.header.stamp = rospy.Time.now() + rospy.Duration(ahead)
        return reading

    @contextlib.contextmanager
    def without(self, name):
        """The cell without one of its nodelets."""
        cell.unload(name)
        try:
            yield
        finally:
            self.loaded.append(cell.Nodelet(name))

    def test_the_job_works(self):
        self.assertEqual(self.first_exit, 0, self.first_said)

    def test_a_second_job_is_rejected_and_the_first_can_be_cancelled(self):
        first = self.job_of("running", LONG)
        self.wait_for_samples()
        self.expect_refused(self.job_of("second"), "a job is running; one at a time")
        first.interrupt()
        code, said = first.finish(10)
        self.assertEqual((code, said.strip()), (130, "cancelled"))
        self.assertTrue(first.left_nothing())
        self.expect_not_recording()

    def test_cancelled_in_every_stage(self):
        for stage in ("scan", "fit", "path", "motion"):
            with self.subTest(stage=stage):
                self.feedback.clear()
                job = self.job_of("cancelled_in_" + stage, FINE)
                cell.wait_until(lambda: self.feedback.find(lambda at, stage=stage: at.feedback.stage == stage), 20.0, stage)
                self.send_cancel.publish(GoalID())
                code, said = job.finish(10)
                self.assertEqual((code, said.strip()), (130, "cancelled"))
                self.assertTrue(job.left_nothing())

    def test_a_result_that_cannot_be_written(self):
        (self.directory / "file").write_text("in the way")
        for out in (self.directory / "file" / "out", pathlib.Path("/proc/out")):
            with self.subTest(out=out):
                job = cell.Job(out, cell.COARSE)
                code, said = job.finish()
                self.assertEqual(code, 2, said)
                self.assertIn(str(out.parent), said)
        self.assertEqual((self.directory / "file").read_text(), "in the way")

    def test_a_disk_that_is_full(self):
        older = {file.name: file.read_bytes() for file in self.first.out.iterdir()}
        manager = ServerProxy(rosgraph.Master(rospy.get_name()).lookupNode("/cell/manager")).getPid("")[2]
        whole = resource.prlimit(manager, resource.RLIMIT_FSIZE, (10000, resource.RLIM_INFINITY))
        try:
            code, said = self.job_of("first").finish()
        finally:
            resource.prlimit(manager, resource.RLIMIT_FSIZE, whole)
        self.assertEqual(code, 2, said)
        self.assertRegex(said, r"^cannot write .*/first\.part/\S+: File too large\n$")
        self.expect_diagnostic("job_server", lambda status: status.level == 2 and status.message == said.strip())
        self.assertFalse(self.first.out.with_name("first.part").exists())
        self.assertEqual({file.name: file.read_bytes() for file in self.first.out.iterdir()}, older)

    def test_a_configuration_that_is_none(self):
        # The client reads the file and refuses keys that are none; what only the whole configuration shows the job
        # server does, and says so in the diagnostics.
        self.expect_refused(self.job_of("unknown", "path: {leed: 0.01}"), "unknown key path.leed, did you mean path.feed?")
        self.expect_not_recording()
        self.expect_failed(self.job_of("range", "scan: {placement: {max_joint_gap: -1}}"), "scan.placement.max_joint_gap")
        # A pipe gives its text once, as a file may that changes: what was checked is what the job server gets.
        piped = cell.Job(self.directory / "piped", arguments=("--config", "/dev/stdin"))
        piped.answer("scan: {placement: {max_joint_gap: -1}}")
        self.expect_failed(piped, "scan.placement.max_joint_gap")

    def test_the_sensor_is_silent(self):
        rospy.set_param("/cell/emulated", False)  # a real robot's cell, whose robot and sensor are silent
        try:
            self.expect_failed(self.job_of("silent"), "scan: no sample came within 4.0 s")
        finally:
            rospy.set_param("/cell/emulated", True)

    def test_the_sensor_falls_silent_and_the_clock_starts_anew(self):
        job = self.job_of("falls_silent", LONG)
        self.wait_for_samples()
        now = rospy.Time.now()
        with self.without("point_laser_emulator"):
            self.expect_failed(job, "scan: samples stopped coming before the end of the scan")
        cell.wait_until(lambda: rospy.Time.now() < now, 20.0, "the new emulator's clock")

    def test_transforms_stop(self):
        job = self.job_of("without_tf", LONG)
        self.wait_for_samples()
        with self.without("cell_frames"):
            self.expect_diagnostic("/cell/scan", lambda status: any(
                value.key == "waiting for transforms" and value.value != "0" for value in status.values))
            self.expect_failed(job, "scan: no sample was placed for 3.0 s; do transforms come")

    def test_the_accumulator_comes_later_than_the_job(self):
        with self.without("scan_accumulator"):
            job = self.job_of("early")
            cell.wait_until(lambda: self.feedback.find(lambda at: at.feedback.stage == "scan"), 20.0, "the job to start")
        code, said = job.finish()
        self.assertEqual(code, 0, said)

    def test_the_job_server_goes_down(self):
        job = self.job_of("without_server", LONG)
        self.wait_for_samples()
        with self.without("job_server"):
            code, said = job.finish(20)
        self.assertEqual(code, 2, said)
        self.assertRegex(said, r"^(run_job: )?the job server is gone\n$")
        self.assertTrue(job.left_nothing())

    def test_a_stage_is_gone(self):
        with self.without("path_planner"):
            self.expect_failed(self.job_of("without_path"), "path: nothing heard of this stage for 4 s; is its nodelet running?")

    def test_a_recording_that_cannot_be_written(self):
        recorder = cell.Nodelet("scan_recorder", "_file:=/proc/scan.bag")
        self.addCleanup(recorder.remove)
        rospy.wait_for_service("/cell/scan_recorder/stop", 20.0)
        self.expect_failed(self.job_of("unrecorded"), "scan: cannot record into /proc/scan.bag: ")
        cell.unload("scan_recorder")

    def test_messages_that_no_sensor_sends(self):
        job = self.job_of("disturbed", LONG)
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
        self.assertEqual(job.dropped(), {"no return": job.dropped()["no return"], "refused": 2})
        self.assertIn("frame_id is 'camera', must be 'sensor'", said)

    def test_a_clock_that_goes_back_while_scanning(self):
        job = self.job_of("clock", LONG)
        self.wait_for_samples()
        self.send_joints.publish(self.reading(-5.0))
        self.expect_failed(job, "the clock of the transforms went back by ", " s on the way; scan again")

    def test_a_subscriber_that_is_slow(self):
        slow = [rospy.Subscriber("/cell/" + topic, rospy.AnyMsg, lambda _: time.sleep(0.5), queue_size=1, buff_size=1024)
                for topic in ("scan_points", "scan_samples", "scan_acknowledged", "tf", "scan_cloud")]
        job = self.job_of("slow")
        code, said = job.finish()
        self.assertEqual(code, 0, said)
        self.assertEqual((job.out / "scan.pcd").read_bytes(), (self.first.out / "scan.pcd").read_bytes())
        for subscriber in slow:
            subscriber.unregister()


if __name__ == "__main__":
    rospy.init_node("cell_faults")
    rostest.rosrun("scan_to_path", "cell_faults", CellFaults, sys.argv)
