# SPDX-FileCopyrightText: 2026 scan_to_path developers
# SPDX-License-Identifier: Apache-2.0
"""Runs the commands and benchmarks that docs/performance.md publishes and holds them to their bars.

usage: measure.py DIRECTORY_OF_EXECUTABLES OUT_DIRECTORY
"""
import json
import os
import pathlib
import platform
import shutil
import subprocess
import sys
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
import performance

RATES = {1_000_000: 4_830, 10_000_000: 48_300}  # [Hz] of sensor and joints, which give about so many samples
RUNS = 5  # of which the median counts


def emulate(executable, rate, log):
    rates = [f"--set=emulate.{name}={rate}" for name in ("sample_rate", "joint_rate")]
    subprocess.run([executable, "emulate", "--errors", "white", *rates, "--quiet", "--out", log], check=True)


def plan(executable, log, out, *flags):
    """One run of the whole command: wall clock, processor time and peak memory of the process, and its stages."""
    command = [executable, "plan", "--input", log, "--threads", "1", "--stop-after", "path", "--quiet", "--out", out, *flags]
    began = time.monotonic()
    process = subprocess.Popen(command)
    _, status, usage = os.wait4(process.pid, 0)
    wall = time.monotonic() - began
    if os.waitstatus_to_exitcode(status) != 0:
        sys.exit(f"{' '.join(map(str, command))}: exit status {os.waitstatus_to_exitcode(status)}")
    stages = json.loads((out / "timing.json").read_text())["stages_s"]
    report = json.loads((out / "report.json").read_text())
    samples = next(stage["in"] for stage in report["stages"] if stage["name"] == "scan")
    return {"samples": samples, "wall_s": wall, "cpu_s": usage.ru_utime + usage.ru_stime,
            "memory_bytes": 1024 * usage.ru_maxrss, "stages_s": stages}


def median_run(runs):
    return sorted(runs, key=lambda run: run["wall_s"])[len(runs) // 2]


def log_to_path(executable, out):
    """Median runs per number of samples, rows over the surface; for the smaller also along the scan's lines."""
    runs = {}
    for number, rate in RATES.items():
        log = out / f"{number}.csv"
        emulate(executable, rate, log)
        repeats = RUNS if number == min(RATES) else 3
        runs[str(number)] = median_run([plan(executable, log, out / "plan") for _ in range(repeats)])
        if number == min(RATES):
            lines = [plan(executable, log, out / "plan", "--set", "path.row_source=scan_lines") for _ in range(RUNS)]
            runs["scan_lines"] = median_run(lines)
        log.unlink()
    shutil.rmtree(out / "plan")
    return runs


def google_benchmarks(executables, out):
    """Median real time [s] and counters by benchmark name."""
    found = {}
    for name in ("scan", "nurbs", "robot"):
        results = out / f"{name}_benchmark.json"
        subprocess.run([executables / f"{name}_benchmark", f"--benchmark_out={results}", "--benchmark_out_format=json"], check=True,
                       stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        for entry in json.loads(results.read_text())["benchmarks"]:
            unit = {"ns": 1e-9, "us": 1e-6, "ms": 1e-3, "s": 1.0}[entry["time_unit"]]
            known = {"name", "family_index", "per_family_instance_index", "run_name", "run_type", "repetitions",
                     "repetition_index", "threads", "iterations", "real_time", "cpu_time", "time_unit", "label"}
            counters = {key: value for key, value in entry.items() if key not in known}
            found[entry["name"]] = {"real_s": unit * entry["real_time"], "cpu_s": unit * entry["cpu_time"], **counters}
    return found


def processor():
    for line in pathlib.Path("/proc/cpuinfo").read_text().splitlines():
        if line.startswith("model name"):
            return line.split(":", 1)[1].strip()
    return platform.machine()


def main(executables, out):
    out.mkdir(parents=True, exist_ok=True)
    print("one and ten million samples, log to path …", file=sys.stderr)
    runs = log_to_path(executables / "scan_to_path", out)
    print("benchmarks beside their rivals, a few minutes …", file=sys.stderr)
    figures = {"processor": processor(), "cores": os.cpu_count(), "load_before": os.getloadavg()[2],
               "log_to_path": runs, "benchmarks": google_benchmarks(executables, out)}
    (out / "performance.json").write_text(json.dumps(figures, indent=1) + "\n")
    missed = performance.missed_bars(figures)
    print(performance.text(figures))
    print("\n".join(f"missed: {line}" for line in missed) or "every bar is met")
    return 1 if missed else 0


if __name__ == "__main__":
    sys.exit(main(*(pathlib.Path(argument) for argument in sys.argv[1:3])))
