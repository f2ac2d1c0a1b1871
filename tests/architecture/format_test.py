#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 scan_to_path developers
# SPDX-License-Identifier: Apache-2.0
"""Fails when a source is not as .clang-format has it. Skipped without Debian 12's clang-format: others differ in detail.

usage: format_test.py SOURCE_DIRECTORY
"""
import pathlib
import shutil
import subprocess
import sys

SKIPPED = 77
VERSION = "version 14."
SOURCE = pathlib.Path(sys.argv[1]).resolve()


def output(*arguments, text=None):
    return subprocess.run(["clang-format", *arguments], check=True, capture_output=True, text=True, cwd=SOURCE, input=text)


def deviations(*arguments, text=None):
    found = output("--dry-run", *arguments, text=text).stderr
    return [line for line in found.splitlines() if "-Wclang-format-violations" in line]


def sources():
    return [str(file) for folder in ("include", "src", "tests") for file in sorted((SOURCE / folder).rglob("*"))
            if file.suffix in (".h", ".cpp")]


if shutil.which("clang-format") is None or VERSION not in output("--version").stdout:
    print("SKIPPED: no clang-format 14 here (Debian package clang-format)")
    sys.exit(SKIPPED)
if not deviations("--assume-filename=src/twin.cpp", text="int  answer();\n"):
    sys.exit("a space too many went unnoticed")
found = deviations(*sources())
print("\n".join(found[:20]))
sys.exit(f"{len(found)} places differ: clang-format -i these files" if found else 0)
