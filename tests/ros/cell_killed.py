#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 scan_to_path developers
# SPDX-License-Identifier: Apache-2.0
"""A cell whose manager or master is killed: the client says so, nothing is half-written, and a new cell works."""
import os
import pathlib
import signal
import socket
import subprocess
import tempfile
import time
import unittest
from xmlrpc.client import ServerProxy

import cell


def free_port():
    with socket.socket() as listener:
        listener.bind(("127.0.0.1", 0))
        return listener.getsockname()[1]


class Cell:
    """A cell with a master of its own."""

    def __init__(self, directory):
        self.uri = f"http://127.0.0.1:{free_port()}"
        self.env = dict(os.environ, ROS_IP="127.0.0.1", ROS_MASTER_URI=self.uri, ROS_LOG_DIR=str(directory / "log"))
        self.log = open(directory / "roslaunch.log", "a")
        self.launch = subprocess.Popen(["roslaunch", "-p", self.uri.rsplit(":", 1)[1], "scan_to_path", "cell.launch"],
                                       env=self.env, stdout=self.log, stderr=self.log, start_new_session=True)
        cell.wait_until(lambda: self.lookup("/cell/point_laser_emulator") is not None, 40, "the cell to come up")

    def master(self):
        return ServerProxy(self.uri)

    def lookup(self, node):
        """The XML-RPC interface of a node."""
        try:
            code, _, uri = self.master().lookupNode("/cell_killed", node)
        except OSError:
            return None
        return ServerProxy(uri) if code == 1 else None

    def kill(self, interface):
        os.kill(interface.getPid("/cell_killed")[2], signal.SIGKILL)

    def close(self):
        if self.launch.poll() is None:
            self.launch.send_signal(signal.SIGINT)
        try:
            self.launch.wait(20)
        finally:
            try:
                os.killpg(self.launch.pid, signal.SIGKILL)
            except ProcessLookupError:
                pass
            self.log.close()


class CellKilled(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory(prefix="scan_to_path_", ignore_cleanup_errors=True)
        self.addCleanup(temporary.cleanup)
        self.directory = pathlib.Path(temporary.name)

    def start(self):
        running = Cell(self.directory)
        self.addCleanup(running.close)
        return running

    def scanning(self, running, name):
        """A job of which the scan has begun."""
        job = cell.Job(self.directory / name, env=running.env)
        def busy():
            code, _, value = running.master().hasParam("/cell_killed", "/cell/job")
            return code == 1 and value
        cell.wait_until(busy, 40, "the job to start")
        return job

    def test_killed_manager(self):
        running = self.start()
        job = self.scanning(running, "out")
        running.kill(running.lookup("/cell/manager"))
        killed = time.monotonic()
        code, said = job.finish(30)
        self.assertEqual((code, said.strip()), (2, "run_job: the job server is gone"))
        self.assertLess(time.monotonic() - killed, 15)
        self.assertTrue(job.left_nothing())
        running.launch.wait(30)  # a cell without its manager goes down
        code, said = cell.Job(self.directory / "next", cell.QUICK, env=self.start().env).finish(60)
        self.assertEqual(code, 0, said)

    def test_killed_master(self):
        running = self.start()
        job = self.scanning(running, "out")
        running.kill(running.master())
        code, said = job.finish(60)
        self.assertEqual(code, 2, said)
        self.assertIn("no ROS master at " + running.uri, said)
        self.assertTrue(job.left_nothing())


if __name__ == "__main__":
    unittest.main(verbosity=2)
