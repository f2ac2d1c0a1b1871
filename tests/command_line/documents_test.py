#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 scan_to_path developers
# SPDX-License-Identifier: Apache-2.0
"""Runs the demo's two commands and fails when the figures or the picture in the documents are not what comes out.

usage: documents_test.py EXECUTABLE SOURCE_DIRECTORY
"""
import json
import pathlib
import subprocess
import sys
import tempfile

executable, source = (pathlib.Path(argument).resolve() for argument in sys.argv[1:3])
with tempfile.TemporaryDirectory(prefix="scan_to_path_") as directory:
    log, result = pathlib.Path(directory, "samples.csv"), pathlib.Path(directory, "cutting")
    subprocess.run([executable, "emulate", "--errors", "realistic", "--seed", "1", "--quiet", "--out", log], check=True)
    subprocess.run([executable, "plan", "--process", "cutting", "--input", log, "--reference", "s_part", "--quiet",
                    "--out", result], check=True)
    check = [sys.executable, source / "scripts/update_docs", "--check"]
    status = subprocess.run([*check, result], check=False).returncode
    # The twin: a result that differs must be noticed.
    report = result / "report.json"
    report.write_text(report.read_text().replace('"failed": 0', '"failed": 1'))
    mutated = subprocess.run([*check, result], check=False, capture_output=True).returncode
    # And so must a benchmark that was run but not published.
    measured = json.loads((source / "docs/performance.json").read_text())
    measured["log_to_path"]["1000000"]["wall_s"] += 0.1
    (pathlib.Path(directory) / "performance.json").write_text(json.dumps(measured))
    unpublished = subprocess.run([*check, pathlib.Path(directory)], check=False, capture_output=True).returncode
if not mutated or not unpublished:
    sys.exit("a changed report went unnoticed" if not mutated else "unpublished figures went unnoticed")
sys.exit(status)
