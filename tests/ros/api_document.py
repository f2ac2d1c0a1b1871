# SPDX-FileCopyrightText: 2026 scan_to_path developers
# SPDX-License-Identifier: Apache-2.0
"""docs/ros_api.md as data."""
import collections
import pathlib
import re

DOCUMENT = pathlib.Path(__file__).resolve().parents[2] / "docs/ros_api.md"

Entry = collections.namedtuple("Entry", "nodelet kind name value")  # value: a type, or a parameter's default


def entries():
    found, nodelet = [], None
    for line in DOCUMENT.read_text(encoding="utf-8").splitlines():
        if line.startswith("## "):
            nodelet = line[3:].strip()
        row = re.match(r"\| (action|publishes|subscribes|service|parameter) \| `([^`]+)` \| ([^|]+) \|", line)
        if row:
            found.append(Entry(nodelet, row[1], row[2], row[3].strip()))
    return found
