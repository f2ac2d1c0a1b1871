#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 scan_to_path developers
# SPDX-License-Identifier: Apache-2.0
"""A cell whose manager or master is killed in the middle of a job: the client says so, nothing is half-written, and a
new cell works. A rostest cannot spare its master, so these cells are started and ended here."""
import os
import pathlib
import signal
import tempfile
import unittest
from xmlrpc.client import ServerProxy

import cell
import ports

SLOW = cell.COARSE.replace("speed: 0.25", "speed: 0.05")  # killed long before it ends


class Cell:
    """A cell with a master of its own."""

    def __init__(self, directory):
        port = str(ports.free())
        self.uri = "http://127.0.0.1:" + port
        self.env = dict(os.environ, ROS_IP="127.0.0.1", ROS_MASTER_URI=self.uri, ROS_LOG_DIR=str(directory / "log"))
        self.launch = cell.Launch("-p", port, "scan_to_path", "cell.launch", env=self.env)

    def ask(self, uri, call, *arguments):
        with ServerProxy(uri) as server:
            return getattr(server, call)("/cell_killed", *arguments)[2]

    def wait_for_job(self):
        cell.wait_until(lambda: self.ask(self.uri, "hasParam", "/cell/job"), 40, "the job to start")

    def kill_manager(self):
        os.kill(self.ask(self.ask(self.uri, "lookupNode", "/cell/manager"), "getPid"), signal.SIGKILL)

    def kill_master(self):
        os.kill(self.ask(self.uri, "getPid"), signal.SIGKILL)


class CellKilled(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory(prefix="scan_to_path_", ignore_cleanup_errors=True)
        self.addCleanup(temporary.cleanup)
        self.directory = pathlib.Path(temporary.name)

    def start(self):
        running = Cell(self.directory)
        self.addCleanup(running.launch.close)
        return running

    def test_killed(self):
        without_manager, without_master = self.start(), self.start()
        jobs = {running: cell.Job(self.directory / name, SLOW, env=running.env)
                for running, name in ((without_manager, "manager"), (without_master, "master"))}
        for running, job in jobs.items():
            self.addCleanup(job.process.kill)
            cell.wait_until(lambda running=running: self.answers(running), 40, "the master")
        without_manager.wait_for_job()
        without_manager.kill_manager()
        without_master.wait_for_job()
        without_master.kill_master()
        # In one line. Whoever looks first says it: the client, or the job server at whatever it does; and roslaunch ends
        # a cell whose manager is gone, master and all.
        for running, limit in ((without_manager, 30), (without_master, 60)):
            code, said = jobs[running].finish(limit)
            self.assertEqual(code, 2, said)
            self.assertRegex(said, r"^[^\n]*(the job server is gone|no ROS master at " + running.uri + r"/?)\n$")
        for job in jobs.values():
            self.assertTrue(job.left_nothing())
        again = self.start()
        without_manager.launch.process.wait(30)  # a cell without its manager goes down
        for name in ("manager", "master"):
            code, said = cell.Job(self.directory / name, cell.COARSE, env=again.env).finish()
            self.assertEqual(code, 0, said)

    @staticmethod
    def answers(running):
        try:
            return running.ask(running.uri, "getPid") > 0
        except OSError:
            return False


if __name__ == "__main__":
    unittest.main(verbosity=2)
