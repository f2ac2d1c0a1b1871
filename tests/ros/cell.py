# SPDX-FileCopyrightText: 2026 scan_to_path developers
# SPDX-License-Identifier: Apache-2.0
"""What the tests of a running cell share: its jobs as a user starts them, its files, and bounded waits."""
import json
import os
import pathlib
import shutil
import signal
import struct
import subprocess
import tempfile
import threading
import time

import roslib.packages

RUN_JOB = pathlib.Path(roslib.packages.find_node("scan_to_path", "run_job")[0])
# Beside the devel space in a build, on PATH when installed.
_BUILT = RUN_JOB.resolve().parents[3] / "scan_to_path"
NODELET = roslib.packages.find_node("nodelet", "nodelet")[0]
COMMAND_LINE = _BUILT if _BUILT.is_file() else pathlib.Path(shutil.which("scan_to_path") or "scan_to_path")

# Rows 12 mm apart, driven faster: a job of a second or two that uses every stage.
QUICK = "emulate: {raster: {pitch: 0.012, speed: 0.2}}\n"
# A few rows, driven fast: about 8 s of scan, done in one.
COARSE = ("emulate: {raster: {pitch: 0.03, speed: 0.25}}\npath: {pitch: 0.015}\n"
          "report: {max_between_rows: 0, max_surface_residual: 0}\n")


def wait_until(condition, seconds, what):
    """Looks every 10 ms; fails when the time is over."""
    limit = time.monotonic() + seconds
    while not condition():
        if time.monotonic() > limit:
            raise AssertionError(f"waited {seconds} s for {what}")
        time.sleep(0.01)


class Job:
    """A job under way, started by the client that users have."""

    def __init__(self, out, configuration="", name="cell", env=None, arguments=(), prefix=()):
        self.out = pathlib.Path(out)
        command = [*prefix, RUN_JOB, "--out", self.out, "--wait", "40", "--server", name + "/job_server", *arguments]
        if configuration:
            self.configuration = tempfile.NamedTemporaryFile("w", suffix=".yaml")
            self.configuration.write(configuration)
            self.configuration.flush()
            command += ["--config", self.configuration.name]
        self.process = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                        text=True, env=env)

    def interrupt(self):
        self.process.send_signal(signal.SIGINT)

    def answer(self, line):
        self.process.stdin.write(line + "\n")
        self.process.stdin.flush()

    def finish(self, seconds=60):
        """Exit status and everything that was said."""
        try:
            output, error = self.process.communicate(timeout=seconds)
        except subprocess.TimeoutExpired:
            self.process.kill()
            raise AssertionError(f"the job did not end within {seconds} s") from None
        return self.process.returncode, output + error

    def left_nothing(self):
        return not self.out.exists() and not self.out.with_name(self.out.name + ".part").exists()

    def report(self):
        return json.loads((self.out / "report.json").read_text())

    def dropped(self):
        """How many samples the scan left out, by reason."""
        return next(stage for stage in self.report()["stages"] if stage["name"] == "scan")["dropped"]

    def points(self):
        """The scan's points by their time [s]: x, y, z [m]."""
        header, data = (self.out / "scan.pcd").read_bytes().split(b"DATA binary\n", 1)
        lines = {line.split()[0]: line.split()[1:] for line in header.decode().splitlines()}
        kinds = {("F", "4"): "f", ("F", "8"): "d", ("U", "4"): "I"}
        layout = "<" + "".join(kinds[kind] for kind in zip(lines["TYPE"], lines["SIZE"]))
        points = (dict(zip(lines["FIELDS"], values)) for values in struct.iter_unpack(layout, data))
        return {point["time"]: (point["x"], point["y"], point["z"]) for point in points}


class Launch:
    """A launch under way; closed, nothing of it is left."""

    def __init__(self, *arguments, env, prefix=()):
        self.process = subprocess.Popen([*prefix, "roslaunch", *arguments], env=env, stdout=subprocess.DEVNULL,
                                        stderr=subprocess.DEVNULL, start_new_session=True)

    def close(self):
        if self.process.poll() is None:
            self.process.send_signal(signal.SIGINT)
        try:
            self.process.wait(30)  # nodelets whose manager is gone take their time
        finally:
            try:
                os.killpg(self.process.pid, signal.SIGKILL)
            except ProcessLookupError:
                pass


def unload(name):
    subprocess.run([NODELET, "unload", "/cell/" + name, "/cell/manager"], check=True, timeout=20, stdout=subprocess.DEVNULL)


class Nodelet:
    """A nodelet put back into the cell; there until removed."""

    def __init__(self, name, *parameters):
        self.process = subprocess.Popen([NODELET, "load", "scan_to_path/" + name, "/cell/manager", "__name:=" + name,
                                         "__ns:=/cell", "/tf:=tf", "/tf_static:=tf_static", *parameters],
                                        stdout=subprocess.DEVNULL)

    def remove(self):
        self.process.terminate()
        self.process.wait(10)


class Listener:
    """Keeps what comes on a topic, with the time it came."""

    def __init__(self, topic, message_type, queue_size=None):
        import rospy
        self.messages = []
        self._lock = threading.Lock()
        self._subscriber = rospy.Subscriber(topic, message_type, self._add, queue_size=queue_size)

    def _add(self, message):
        with self._lock:
            self.messages.append((time.monotonic(), message))

    def clear(self):
        with self._lock:
            self.messages = []

    def find(self, condition=lambda message: True):
        with self._lock:
            return next(((at, message) for at, message in self.messages if condition(message)), None)

    def close(self):
        self._subscriber.unregister()
