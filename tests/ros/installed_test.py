#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 scan_to_path developers
# SPDX-License-Identifier: Apache-2.0
"""What cmake --install makes works by itself, wherever it lies: the cell through roslaunch, a job, the command line.

usage: installed_test.py BUILD_DIRECTORY PREFIX
"""
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

import ports

PREFIX = pathlib.Path(sys.argv.pop(2))
BUILD = pathlib.Path(sys.argv.pop(1))
QUICK = "emulate: {raster: {pitch: 0.012, speed: 0.2}}\n"


class Installed(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory(prefix="scan_to_path_")
        cls.directory = pathlib.Path(cls.temporary.name)
        # Moved elsewhere at once: nothing may know where it was meant to lie.
        subprocess.run(["cmake", "--install", BUILD], check=True, stdout=subprocess.DEVNULL,
                       env={**os.environ, "DESTDIR": str(cls.directory / "stage")})
        cls.prefix = cls.directory / "moved"
        (cls.directory / "stage" / PREFIX.relative_to("/")).rename(cls.prefix)

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    def script(self, *lines):
        """The shell of a user who has sourced what was installed, and nothing else."""
        environment = {"HOME": str(self.directory), "PATH": "/usr/bin:/bin", "LANG": "C.UTF-8", "ROS_IP": "127.0.0.1",
                       "ROS_MASTER_URI": f"http://127.0.0.1:{ports.free()}"}
        done = subprocess.run(["bash", "-c", "\n".join([f"source {self.prefix}/setup.bash", *lines])], cwd=self.directory,
                              env=environment, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=120)
        self.assertEqual(done.returncode, 0, done.stdout)
        return done.stdout

    def test_the_cell_runs_a_job(self):
        (self.directory / "quick.yaml").write_text(QUICK)
        self.script(
            'roslaunch -p "${ROS_MASTER_URI##*:}" scan_to_path cell.launch > cell.log 2>&1 &',
            "trap 'kill $!; wait' EXIT",
            "rosrun scan_to_path run_job --wait 40 --config quick.yaml --out job || { cat cell.log; exit 1; }")
        program = "".join(path.read_text() for path in (self.directory / "job").glob("program*.mod"))
        self.assertIn("MoveL", program)
        log = (self.directory / "cell.log").read_text()
        self.assertNotIn(str(BUILD), log)

    def test_the_command_line_and_snapshot_are_there(self):
        said = self.script("scan_to_path --version", "snapshot --help", "scan_to_path plan --print-config > all.yaml")
        self.assertIn("Draw what rviz shows", said)
        self.assertIn("ball_radius", (self.directory / "all.yaml").read_text())

    def test_nothing_refers_to_the_build_tree(self):
        referring = [str(path.relative_to(self.prefix)) for path in self.prefix.rglob("*")
                     if path.is_file() and path.suffix != ".pyc" and str(BUILD).encode() in path.read_bytes()]
        self.assertEqual(referring, [])


if __name__ == "__main__":
    unittest.main()
