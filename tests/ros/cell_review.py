#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 scan_to_path developers
# SPDX-License-Identifier: Apache-2.0
"""A job that is reviewed writes what it would have written anyway, or nothing, and the next job runs."""
import pathlib
import sys
import tempfile
import unittest

import rospy
import rostest
from scan_to_path.msg import MotionPlan, RunJobActionFeedback

import cell

FILES = ("scan.pcd", "path.csv", "trajectory.csv", "pulses.csv", "program.mod", "report.json")


class CellReview(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory(prefix="scan_to_path_")
        self.addCleanup(temporary.cleanup)
        self.directory = pathlib.Path(temporary.name)
        self.feedback = cell.Listener("/cell/job_server/run/feedback", RunJobActionFeedback)
        self.addCleanup(self.feedback.close)
        self.motion = cell.Listener("/cell/motion_plan", MotionPlan)
        self.addCleanup(self.motion.close)

    def start(self, name, *arguments):
        self.feedback.clear()
        self.motion.clear()
        return cell.Job(self.directory / name, cell.QUICK, arguments=arguments)

    def wait_for_review(self):
        cell.wait_until(lambda: self.feedback.find(lambda message: message.feedback.stage == "review"), 40.0, "review")

    def test_accepted_is_what_no_review_writes_and_else_nothing(self):
        cancelled = self.start("cancelled", "--review")
        self.wait_for_review()
        cell.wait_until(self.motion.find, 5.0, "the motion that is judged")
        cancelled.interrupt()
        status, said = cancelled.finish()
        self.assertEqual(status, 130, said)
        self.assertTrue(said.strip().endswith("cancelled"), said)  # maybe behind the question
        self.assertTrue(cancelled.left_nothing())

        rejected = self.start("rejected", "--review")
        self.wait_for_review()
        rejected.answer("n")
        status, said = rejected.finish()
        self.assertEqual(status, 130)
        self.assertIn("rejected by the user", said)
        self.assertTrue(rejected.left_nothing())

        plain = self.start("plain")
        status, said = plain.finish()
        self.assertEqual(status, 0, said)
        self.assertIsNone(self.feedback.find(lambda message: message.feedback.stage == "review"))

        accepted = self.start("accepted", "--review")
        self.wait_for_review()
        self.assertTrue(accepted.left_nothing())
        accepted.answer("y")
        status, said = accepted.finish()
        self.assertEqual(status, 0, said)
        for name in FILES:
            self.assertEqual((accepted.out / name).read_bytes(), (plain.out / name).read_bytes(), name)


if __name__ == "__main__":
    rospy.init_node("cell_review")
    rostest.rosrun("scan_to_path", "cell_review", CellReview, sys.argv)
