#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 scan_to_path developers
# SPDX-License-Identifier: Apache-2.0
"""Every launch file can be loaded, alone and with the arguments that change what it starts; all that it starts is there.

usage: launch_files_test.py SOURCE_DIRECTORY
"""
import pathlib
import re
import sys
import unittest

import roslaunch.config
import roslaunch.loader
import roslaunch.xmlloader
import roslib.packages

SOURCE = pathlib.Path(sys.argv.pop(1))
LAUNCH_FILES = sorted((SOURCE / "launch").glob("*.launch"))
ARGUMENTS = {
    "cell": [[], ["sim:=false", "gui:=true"], ["bag:=scan.bag", "record:=other.bag"],
             ["workpiece:=part.stl", "workpiece_units:=mm", "workpiece_pose:=0.4 -0.5 0.4 0 0 0", "real_time:=true"],
             ["side:=sensor", "record:=scan.bag"], ["side:=planning", "gui:=true"],
             [f"config:={SOURCE}/config/part_scan.yaml", "ns:=left", "seed:=3", "errors:=white"]],
    "figures": [[], ["gui:=fig_10_normals"]],
}


def loaded(path, arguments):
    config = roslaunch.config.ROSLaunchConfig()
    roslaunch.xmlloader.XmlLoader().load(str(path), config, argv=[str(path), *arguments], verbose=False)
    return config


def plugins():
    text = (SOURCE / "nodelet_plugins.xml").read_text(encoding="utf-8")
    return set(re.findall(r'<class name="([^"]+)"', text))


class LaunchFiles(unittest.TestCase):
    def test_all_are_looked_at(self):
        self.assertEqual([path.stem for path in LAUNCH_FILES], sorted(ARGUMENTS))

    def test_everything_that_is_started_is_there(self):
        for path in LAUNCH_FILES:
            for arguments in ARGUMENTS[path.stem]:
                with self.subTest(launch=path.name, arguments=arguments):
                    config = loaded(path, arguments)
                    self.assertEqual(config.config_errors, [])
                    self.assertGreater(len(config.nodes), 0)
                    for node in config.nodes:
                        self.assertTrue(roslib.packages.find_node(node.package, node.type), node.type)
                        nodelet = re.match(r"load (\S+)", node.args)
                        if nodelet:
                            self.assertIn(nodelet[1], plugins())
                        for config_file in re.findall(r"-d (\S+)", node.args):
                            self.assertTrue(pathlib.Path(config_file).is_file(), config_file)

    def test_arguments_choose_what_is_started(self):
        def nodes(*arguments):
            return {node.name for node in loaded(SOURCE / "launch/cell.launch", list(arguments)).nodes}
        self.assertEqual(nodes("record:=scan.bag") - nodes(), {"scan_recorder"})
        self.assertEqual(nodes("gui:=true") - nodes(), {"rviz"})
        self.assertEqual(nodes() - nodes("sim:=false"), {"point_laser_emulator"})

    def test_two_sides_are_the_cell(self):
        """Each node on one of two hosts, with a manager on both."""
        def commands(*arguments):
            config = loaded(SOURCE / "launch/cell.launch", ["gui:=true", "record:=scan.bag", *arguments])
            return {(node.name, node.type, node.args.replace("sensor_manager", "manager")) for node in config.nodes}
        both, sensor, planning = commands(), commands("side:=sensor"), commands("side:=planning")
        manager = ("manager", "nodelet", "manager")
        sensor_manager = ("sensor_manager", *manager[1:])
        self.assertEqual(sensor | planning, both | {sensor_manager})
        self.assertEqual(sensor & planning, set())
        self.assertIn(manager, planning)
        self.assertEqual({name for name, *_ in sensor}, {"sensor_manager", "point_laser_emulator", "cell_frames",
                                                         "scan_accumulator", "scan_recorder"})
        with self.assertRaises(roslaunch.xmlloader.XmlParseException):
            commands("side:=left")

    def test_the_documented_arguments_are_the_launch_files(self):
        """Each argument says what it is for."""
        for path in LAUNCH_FILES:
            for argument in re.findall(r"<arg [^>]*>", path.read_text(encoding="utf-8")):
                self.assertRegex(argument, r'doc="[^"]{10,}"|ns', argument)

    def test_a_workpiece_pose_reaches_the_configuration(self):
        params = loaded(SOURCE / "launch/cell.launch", ["workpiece_pose:=0.4 -0.5 0.4 0 0 1.5"]).params
        values = {name: param.value for name, param in params.items()}
        self.assertEqual(values["/cell/configuration/cell/workpiece/xyz"], [0.4, -0.5, 0.4])
        self.assertEqual(values["/cell/configuration/cell/workpiece/rpy"], [0, 0, 1.5])


if __name__ == "__main__":
    unittest.main()
