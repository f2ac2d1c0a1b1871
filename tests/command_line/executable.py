# SPDX-FileCopyrightText: 2026 scan_to_path developers
# SPDX-License-Identifier: Apache-2.0
"""What tests that drive the executable share. The executable's path is their first argument."""
import pathlib
import subprocess
import sys

EXECUTABLE = pathlib.Path(sys.argv.pop(1)).resolve()
# A strip of the S part in 2 s of computing: the raster's options keep it small.
SMALL = ["--set", "emulate.raster.pitch=0.02", "--set", "emulate.sample_rate=500", "--set", "emulate.joint_rate=500"]


def run(*arguments, **keywords):
    return subprocess.run([str(EXECUTABLE), *map(str, arguments)], capture_output=True, text=True, timeout=120,
                          check=False, **keywords)


def write_plate(file, height=0.0, unit=1.0, size=(0.24, 0.16)):
    """A rectangle from the origin to `size` [m] at `height` [m], as an OFF file whose unit is `unit` m."""
    corners = [(x / unit, y / unit, height / unit) for y in (0, size[1]) for x in (0, size[0])]
    file.write_text("OFF\n4 2 0\n" + "".join("%g %g %g\n" % corner for corner in corners) + "3 0 1 3\n3 0 3 2\n")
    return file
