#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 scan_to_path developers
# SPDX-License-Identifier: Apache-2.0
"""Checks what no compiler checks: who includes whom, no ROS in the core, no truth outside emulator and tests."""
import pathlib
import re
import sys
import unittest

ROOT = pathlib.Path(sys.argv.pop(1)).resolve()
MODULES = ["common", "geometry", "nurbs", "mesh", "robot", "scan", "sensing", "toolpath", "process", "motion",
           "program", "verification", "pipeline"]
# The analytic worlds: only their own module, executables and tests may see them.
TRUTH = {"analytic_surface.h", "height_field.h", "worlds.h"}
ROS = re.compile(r"^(ros/|tf2|pcl_ros/|pcl_conversions/|nodelet/|pluginlib/|rviz/|[a-z_]+_msgs/|scan_to_path_ros/|"
                 r"scan_to_path/[A-Z]\w*\.h)")
INCLUDE = re.compile(r'^\s*#\s*include\s*[<"]([^>"]+)[>"]', re.MULTILINE)


def includes(path):
    return INCLUDE.findall(path.read_text(encoding="utf-8"))


# What is nothing without the nodelets around it: cell_job.py tests it.
TESTED_IN_THE_CELL = {"nodelet_runner", "stage", "stage_results", "log_player", "playback_watch"}
# The nodelet that plays robot and part.
EMULATORS = {"point_laser_emulator.cpp"}


def ros_files():
    for base in ("include/scan_to_path_ros", "src/ros", "src/nodelets"):
        for path in sorted((ROOT / base).rglob("*")):
            if path.suffix in (".h", ".cpp"):
                yield base, path


def core_files():
    for module in MODULES:
        for base in (ROOT / "include/scan_to_path" / module, ROOT / "src" / module):
            for path in sorted(base.rglob("*")):
                if path.suffix in (".h", ".cpp"):
                    yield module, path


def violations(files, rule):
    return [f"{path.relative_to(ROOT)} includes {name}" for module, path in files for name in includes(path)
            if rule(module, name)]


def looks_downstream(module, name):
    match = re.match(r"scan_to_path/(\w+)/", name)
    return bool(match) and MODULES.index(match.group(1)) > MODULES.index(module)


def sees_truth(module, name):
    return module != "geometry" and pathlib.PurePath(name).name in TRUTH


def sees_emulated_world(base, name):
    return sees_truth(base, name) or name == "tools/emulated_world.h" or "emulate" in name


class IncludeGraph(unittest.TestCase):
    def test_sees_the_tree(self):
        self.assertGreater(len(list(core_files())), 60)

    def test_modules_use_only_those_before_them(self):
        self.assertEqual(violations(core_files(), looks_downstream), [])

    def test_core_has_no_ros(self):
        self.assertEqual(violations(core_files(), lambda module, name: bool(ROS.match(name))), [])

    def test_truth_stays_with_emulator_and_tests(self):
        self.assertEqual(violations(core_files(), sees_truth), [])

    def test_truth_stays_with_the_emulating_nodelet(self):
        files = [(base, path) for base, path in ros_files() if path.name not in EMULATORS]
        self.assertGreater(len(files), 20)
        self.assertEqual(violations(files, sees_emulated_world), [])
        subscribing = [str(path.relative_to(ROOT)) for _, path in files if "truth/" in path.read_text(encoding="utf-8")]
        self.assertEqual(subscribing, [])

    def test_ros_sources_are_thin(self):
        longest = 230  # lines
        thick = [str(path.relative_to(ROOT)) for _, path in ros_files()
                 if len(path.read_text(encoding="utf-8").splitlines()) > longest]
        self.assertEqual(thick, [])

    def test_every_ros_source_has_its_test(self):
        tests = "".join(path.read_text(encoding="utf-8") for path in (ROOT / "tests/ros").glob("*") if path.is_file())
        missing = [str(path.relative_to(ROOT)) for base, path in ros_files() if base == "src/ros"
                   and (ROOT / "include/scan_to_path_ros" / (path.stem + ".h")).exists()
                   and not (ROOT / "tests/ros" / (path.stem + "_test.cpp")).exists()
                   and path.stem not in TESTED_IN_THE_CELL]
        self.assertEqual(missing, [])
        plugins = (ROOT / "nodelet_plugins.xml").read_text(encoding="utf-8")
        launch = (ROOT / "launch/cell.launch").read_text(encoding="utf-8")
        for base, path in ros_files():
            if base == "src/nodelets":
                self.assertIn(f'name="scan_to_path/{path.stem}"', plugins)
                self.assertIn(f"load scan_to_path/{path.stem} ", launch)  # which cell_job runs
        self.assertIn("launch/cell.launch", tests)

    def test_core_does_not_print(self):
        printing = re.compile(r"std::c(out|err)\b|\bprintf\(|\bputs\(")
        found = [str(path.relative_to(ROOT)) for _, path in core_files()
                 if printing.search(re.sub(r"snprintf\(", "", path.read_text(encoding="utf-8")))]
        self.assertEqual(found, [])

    def test_every_public_source_has_its_test(self):
        # A source without a public header is a part of one that has: it is tested through that.
        missing = [str(path.relative_to(ROOT)) for module, path in core_files() if path.suffix == ".cpp"
                   and (ROOT / "include/scan_to_path" / module / (path.stem + ".h")).exists()
                   and not (ROOT / "tests" / module / (path.stem + "_test.cpp")).exists()]
        self.assertEqual(missing, [])

    def test_every_file_names_its_licence(self):
        files = [path for base in ("include", "src", "tests", "scripts", "cmake") for path in (ROOT / base).rglob("*")
                 if path.suffix in (".h", ".cpp", ".py", ".cmake", ".sh")]
        self.assertEqual([str(path) for path in files
                          if "SPDX-License-Identifier: Apache-2.0" not in path.read_text(encoding="utf-8")[:300]], [])

    def test_rules_catch_what_they_should(self):
        self.assertTrue(looks_downstream("nurbs", "scan_to_path/scan/scan_cloud.h"))
        self.assertFalse(looks_downstream("scan", "scan_to_path/nurbs/curve.h"))
        self.assertTrue(sees_truth("process", "scan_to_path/geometry/height_field.h"))
        for name in ("ros/ros.h", "sensor_msgs/PointCloud2.h", "scan_to_path/ToolPath.h", "tf2_ros/buffer.h"):
            self.assertTrue(ROS.match(name), name)
        self.assertFalse(ROS.match("scan_to_path/toolpath/tool_path.h"))
        self.assertTrue(sees_emulated_world("src/nodelets", "scan_to_path/sensing/emulate_scan.h"))
        self.assertTrue(sees_emulated_world("src/nodelets", "tools/emulated_world.h"))


if __name__ == "__main__":
    unittest.main()
