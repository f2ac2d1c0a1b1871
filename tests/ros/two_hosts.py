#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 scan_to_path developers
# SPDX-License-Identifier: Apache-2.0
"""A cell on two hosts: robot, sensor and accumulator on one, the rest on the other. Two network namespaces with a cable
between them stand for the hosts; where they are not permitted the test is skipped."""
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import time
import unittest
from xmlrpc.client import ServerProxy

import cell

SKIPPED = 77
SENSOR, PLANNING = "10.77.0.1", "10.77.0.2"
MASTER = f"http://{SENSOR}:11311"  # a namespace has its ports to itself
IP = shutil.which("ip", path=os.environ.get("PATH", "") + ":/usr/sbin:/sbin")
FILES = ("path.csv", "trajectory.csv", "pulses.csv")


def skip(why):
    print(f"SKIPPED: {why}")
    sys.exit(SKIPPED)


def enter_namespace():
    """Starts this test again where it may lay cables: in a network namespace of its own."""
    if IP is None:
        skip("no ip (package iproute2) to join network namespaces with")
    for options in (["--user", "--map-root-user", "--net"], ["--net"]):
        tried = subprocess.run(["unshare", *options, "true"], capture_output=True, text=True, check=False)
        if tried.returncode == 0:
            os.execvp("unshare", ["unshare", *options, sys.executable, __file__, "inside"])
    skip("network namespaces are not permitted: " + tried.stderr.strip())


class Host:
    """Where commands run, and under which address."""

    def __init__(self, address, directory, prefix=()):
        self.prefix = prefix
        self.env = {**os.environ, "ROS_IP": address, "ROS_MASTER_URI": MASTER, "ROS_LOG_DIR": str(directory / address)}
        self.env.pop("ROS_HOSTNAME", None)

    def connect(self, address):
        for command in (["addr", "add", address + "/30", "dev", "cable"], ["link", "set", "cable", "up"],
                        ["link", "set", "lo", "up"]):
            subprocess.run([*self.prefix, IP, *command], check=True, timeout=10)

    def launch(self, *arguments):
        return cell.Launch(*arguments, env=self.env, prefix=self.prefix)


def second_namespace():
    """A process that keeps one, until this one ends."""
    keeper = subprocess.Popen(["unshare", "--net", "sh", "-c", "echo; exec cat"], stdin=subprocess.PIPE,
                              stdout=subprocess.PIPE)
    keeper.stdout.readline()
    return keeper


def ask_master(call, *arguments):
    with ServerProxy(MASTER) as master:
        return getattr(master, call)("/two_hosts", *arguments)[2]


class TwoHosts(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        temporary = tempfile.TemporaryDirectory(prefix="scan_to_path_", ignore_cleanup_errors=True)
        cls.addClassCleanup(temporary.cleanup)
        directory = pathlib.Path(temporary.name)
        sensor = Host(SENSOR, directory)
        planning = Host(PLANNING, directory, ("nsenter", "--net", "--target", str(KEEPER.pid)))
        sensor.connect(SENSOR)
        planning.connect(PLANNING)
        started = time.monotonic()
        launches = [sensor.launch("scan_to_path", "cell.launch", "side:=sensor"),
                    planning.launch("--wait", "scan_to_path", "cell.launch", "side:=planning", "speed:=200")]
        for launch in launches:
            cls.addClassCleanup(launch.close)
        cls.job = cell.Job(directory / "cell", cell.QUICK, env=planning.env, prefix=planning.prefix, arguments=["--play"])
        cls.addClassCleanup(cls.job.process.kill)
        cls.one_host = cls.command_line(directory, cls.job.configuration.name)
        cls.exit, cls.said = cls.job.finish()
        print(f"brought up on two hosts, planned and played back in {time.monotonic() - started:.1f} s", flush=True)
        cls.publishers, cls.subscribers, _ = (dict(state) for state in ask_master("getSystemState"))
        cls.addresses = {name: ask_master("lookupNode", "/cell/" + name) for name in ("sensor_manager", "manager")}

    @staticmethod
    def command_line(directory, configuration):
        log, out = directory / "samples.csv", directory / "command_line"
        for arguments in (["emulate", "--errors", "realistic", "--seed", "1", "--out", log], ["plan", "--input", log, "--out", out]):
            subprocess.run([cell.COMMAND_LINE, *arguments, "--config", configuration, "--quiet"], check=True, timeout=60)
        return out

    def test_the_program_is_the_command_lines(self):
        self.assertEqual(self.exit, 0, self.said)
        for name in FILES:
            here = (self.job.out / name).read_bytes()
            self.assertGreater(len(here), 10000)
            self.assertEqual(here, (self.one_host / name).read_bytes(), name)

    def test_no_sample_is_lost(self):
        def scan(report):
            return next(stage for stage in report["stages"] if stage["name"] == "scan")
        self.assertEqual(scan(self.job.report()), scan(json.loads((self.one_host / "report.json").read_text())))
        self.assertGreater(scan(self.job.report())["in"], 10000)

    def test_each_side_is_where_it_should_be(self):
        self.assertIn(f"//{SENSOR}:", self.addresses["sensor_manager"])
        self.assertIn(f"//{PLANNING}:", self.addresses["manager"])
        for topic in ("/cell/scan_cloud", "/cell/tf_static", "/clock"):
            self.assertEqual(self.publishers[topic], ["/cell/sensor_manager"], topic)
            self.assertIn("/cell/manager", self.subscribers[topic], topic)
        self.assertEqual(self.publishers["/cell/fitted_scan"], ["/cell/manager"])

    def test_playing_back_goes_there_and_back(self):
        """Joint states from one side, by simulated time of the other; transforms from the other."""
        played = re.search(r"played back: (\d+) waypoints, tool off the path by ([\d.]+) um and ([\d.]+) deg at most\n", self.said)
        self.assertTrue(played, self.said)  # it ends otherwise where waypoints were not seen
        rows = [line for line in (self.job.out / "path.csv").read_text().splitlines() if line[:1] != "#"]
        self.assertEqual(int(played[1]), len(rows) - 1)
        self.assertLessEqual(float(played[2]), 1.0)


if __name__ == "__main__":
    if sys.argv[1:] != ["inside"]:
        enter_namespace()
    KEEPER = second_namespace()
    CABLE = subprocess.run([IP, "link", "add", "cable", "type", "veth", "peer", "name", "cable", "netns", str(KEEPER.pid)],
                           capture_output=True, text=True, check=False)
    if CABLE.returncode != 0:
        skip("no cable between network namespaces: " + CABLE.stderr.strip())
    unittest.main(argv=sys.argv[:1], verbosity=2)
