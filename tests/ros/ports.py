# SPDX-FileCopyrightText: 2026 scan_to_path developers
# SPDX-License-Identifier: Apache-2.0
"""Ports for masters of a test's own."""
import itertools
import os
import socket

_asked = itertools.count()


def free():
    """Below the ports that the system gives away by itself: another cell's nodes could get it before the master."""
    for port in itertools.count(12000 + os.getpid() % 16000 + next(_asked)):
        with socket.socket() as listener:
            try:
                listener.bind(("127.0.0.1", port))
                return port
            except OSError:
                pass
