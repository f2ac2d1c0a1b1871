#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 scan_to_path developers
# SPDX-License-Identifier: Apache-2.0
"""The running cell has the topics, services and parameters that docs/ros_api.md says, and no others."""
import pathlib
import re
import sys
import tempfile
import unittest

import rosgraph
import rospy
import rostest
import yaml

import api_document
import cell

MANAGER = "/cell/manager"
LAUNCH = pathlib.Path(__file__).resolve().parents[2] / "launch/cell.launch"
# What roscpp, the nodelet manager and actionlib bring along.
FOREIGN_TOPICS = re.compile(r"/rosout|.*/bond$|/cell/job_server/run/")
FOREIGN_SERVICES = re.compile(r".*/(get_loggers|set_logger_level|list|load_nodelet|unload_nodelet)$")


def resolved(name, nodelet):
    if name.startswith("~"):
        return f"/cell/{nodelet}/{name[1:]}"
    return name if name.startswith("/") else f"/cell/{name}"


def documented(kind):
    return {(resolved(entry.name, entry.nodelet), entry.value) for entry in ENTRIES if entry.kind == kind}


ENTRIES = [entry for entry in api_document.entries() if entry.nodelet != "scan_recorder"]  # which is not loaded here


class CellApi(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory(prefix="scan_to_path_")
        job = cell.Job(pathlib.Path(cls.temporary.name) / "out", cell.QUICK)
        cls.exit, cls.said = job.finish(60)
        master = rosgraph.Master(rospy.get_name())
        publishers, subscribers, cls.services = master.getSystemState()
        types = dict(master.getTopicTypes())

        def topics(state):
            return {(name, types.get(name)) for name, nodes in state
                    if MANAGER in nodes and not FOREIGN_TOPICS.match(name)}
        cls.published, cls.subscribed = topics(publishers), topics(subscribers)

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    def test_a_job_has_run(self):
        self.assertEqual(self.exit, 0, self.said)

    def test_topics_published_are_the_documented_ones(self):
        self.assertGreater(len(self.published), 15)
        self.assertEqual(self.published, documented("publishes"))

    def test_topics_subscribed_are_the_documented_ones(self):
        self.assertGreater(len(self.subscribed), 10)
        self.assertEqual(self.subscribed, documented("subscribes"))

    def test_services_are_the_documented_ones(self):
        found = {name for name, nodes in self.services if MANAGER in nodes and not FOREIGN_SERVICES.match(name)}
        self.assertEqual(found, {name for name, _ in documented("service")})

    def test_the_action_is_the_documented_one(self):
        self.assertEqual([(entry.name, entry.value) for entry in ENTRIES if entry.kind == "action"],
                         [("job_server/run", "scan_to_path/RunJob")])
        types = dict(rosgraph.Master(rospy.get_name()).getTopicTypes())
        self.assertEqual(types["/cell/job_server/run/goal"], "scan_to_path/RunJobActionGoal")

    def test_parameters_have_the_documented_defaults(self):
        """But for those that the launch file sets: of these it is enough that they are there."""
        launched = set(re.findall(r'<param (?:if="[^"]*" )?name="(\w+)"', LAUNCH.read_text(encoding="utf-8")))
        self.assertIn("seed", launched)
        compared = 0
        for entry in ENTRIES:
            if entry.kind != "parameter":
                continue
            name, default = resolved(entry.name, entry.nodelet), entry.value
            self.assertEqual(rospy.has_param(name), default not in ("none", "configuration") or "seed" in name, name)
            if default in ("none", "configuration") or entry.name.lstrip("~") in launched:
                continue
            value = rospy.get_param(name)
            self.assertEqual((type(value), value), (type(yaml.safe_load(default)), yaml.safe_load(default)), name)
            compared += 1
        self.assertGreaterEqual(compared, 10)

    def test_parameters_set_are_documented(self):
        nodelets = {entry.nodelet for entry in ENTRIES}
        documented_names = {resolved(entry.name, entry.nodelet) for entry in ENTRIES if entry.kind == "parameter"}
        found = {f"/cell/{nodelet}/{name}" for nodelet in nodelets
                 for name in rospy.get_param(f"/cell/{nodelet}", {}) if not isinstance(name, dict)}
        self.assertEqual({name for name in found if not name.endswith("/run")} - documented_names, set())


if __name__ == "__main__":
    rospy.init_node("cell_api")
    rostest.rosrun("scan_to_path", "cell_api", CellApi, sys.argv)
