#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 scan_to_path developers
# SPDX-License-Identifier: Apache-2.0
"""Two cells side by side scan at the robot's pace: each makes its own program, what is shown keeps up with the sensor,
and a processor core is enough for a cell."""
import os
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
from sensor_msgs.msg import PointCloud2

import cell

LAG, CORES = 0.2, 1.0  # [s], processor seconds of a cell's manager in a second of its scan


def processor_time(process):
    fields = pathlib.Path(f"/proc/{process}/stat").read_text().rsplit(")", 1)[1].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


class CellLive(unittest.TestCase):
    def test_two_cells_keep_up_and_apart(self):
        temporary = tempfile.TemporaryDirectory(prefix="scan_to_path_")
        self.addCleanup(temporary.cleanup)
        directory = pathlib.Path(temporary.name)
        configuration = directory / "job.yaml"
        configuration.write_text(cell.COARSE)
        shown, jobs = {}, {}
        for name in ("left", "right"):
            shown[name] = cell.Listener(f"/{name}/scan_points", PointCloud2)
            jobs[name] = subprocess.Popen(
                [cell.RUN_JOB, "--out", directory / name, "--config", configuration, "--server", f"{name}/job_server"],
                stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        for name in shown:
            cell.wait_until(shown[name].find, 40.0, f"points of the {name} cell")
        master = rosgraph.Master(rospy.get_name())
        manager = ServerProxy(master.lookupNode("/left/manager")).getPid(rospy.get_name())[2]
        begin, used = time.monotonic(), processor_time(manager)
        time.sleep(3.0)  # of both scans: what is measured
        cores = (processor_time(manager) - used) / (time.monotonic() - begin)
        for name, job in jobs.items():
            said, _ = job.communicate(timeout=60)
            self.assertEqual(job.returncode, 0, said)
        since_epoch = time.time() - time.monotonic()
        for name, listener in shown.items():
            came = [(at + since_epoch, message.header.stamp.to_sec()) for at, message in listener.messages]
            # Until the next message comes, the newest point shown grows old.
            lags = sorted(later - stamp for (_, stamp), (later, _) in zip(came, came[1:-1]))
            self.assertGreater(len(lags), 20)
            lag = lags[int(0.95 * len(lags))]
            print(f"{name}: newest point shown is {lag:.3f} s old, 95 % of the time less")
            self.assertLess(lag, LAG)
        print(f"manager of a cell that scans: {cores:.2f} cores")
        self.assertGreater(cores, 0.0)
        self.assertLess(cores, CORES)
        # Other noise and another place: their paths are not each other's.
        left, right = ((directory / name / "path.csv").read_text() for name in ("left", "right"))
        self.assertNotEqual(left, right)


if __name__ == "__main__":
    rospy.init_node("cell_live")
    rostest.rosrun("scan_to_path", "cell_live", CellLive, sys.argv)
