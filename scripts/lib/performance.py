# SPDX-FileCopyrightText: 2026 scan_to_path developers
# SPDX-License-Identifier: Apache-2.0
"""What scripts/benchmark measured (performance.json) as tables, and the bars it is held to."""

MOST_WALL = 1.5  # [s] from a log of a million samples to the path
MOST_FIT = 0.3  # [s] of it for fit, normals and frames
MOST_MEMORY = 600e6  # [bytes]
MOST_GROWTH = 1.15  # time per sample of ten million over that of one million: linear, with room for caches
LEAST_GAIN = 60.0  # over PCL's most accurate normals, or the first as accurate as ours
NEIGHBOURS = (10, 20, 50, 100, 200, 400)
OURS = {1: "fitAndNormals/threads:1/real_time", 2: "fitAndNormals/threads:2/real_time"}


def pcl(figures, omp):
    name = "pclNormalsOmp/{}/iterations:1/real_time" if omp else "pclNormals/{}/iterations:1"
    return {k: figures["benchmarks"][name.format(k)] for k in NEIGHBOURS}


def rival(figures, omp):
    """The k that first reaches our accuracy, or else the most accurate one; and whether it does."""
    ours = figures["benchmarks"][OURS[2 if omp else 1]]["mean_deg"]
    found = pcl(figures, omp)
    reaching = [k for k in NEIGHBOURS if found[k]["mean_deg"] <= ours]
    k = reaching[0] if reaching else min(NEIGHBOURS, key=lambda each: found[each]["mean_deg"])
    return k, bool(reaching)


def gain(figures, omp):
    k, _ = rival(figures, omp)
    return pcl(figures, omp)[k]["real_s"] / figures["benchmarks"][OURS[2 if omp else 1]]["real_s"]


def fit_and_frames(run):
    return run["stages_s"]["fit"] + run["stages_s"]["path"]


def per_sample(run):
    return run["wall_s"] / run["samples"]


def growth(figures):
    runs = figures["log_to_path"]
    return per_sample(runs["10000000"]) / per_sample(runs["1000000"])


def bars(figures):
    """Name, value, limit and whether larger is better, of everything that is promised."""
    runs = figures["log_to_path"]
    for name in ("1000000", "scan_lines"):
        yield f"{name}: log to path [s]", runs[name]["wall_s"], MOST_WALL, False
        yield f"{name}: fit, normals, frames [s]", fit_and_frames(runs[name]), MOST_FIT, False
        yield f"{name}: memory [bytes]", runs[name]["memory_bytes"], MOST_MEMORY, False
    yield "time per sample, ten million over one million", growth(figures), MOST_GROWTH, False
    yield "normals, PCL's time over ours", gain(figures, False), LEAST_GAIN, True


def missed_bars(figures):
    return [f"{name}: {value:.4g}, {'at least' if more else 'at most'} {limit:g}"
            for name, value, limit, more in bars(figures) if (value < limit if more else value > limit)]


def table(head, rows):
    lines = [head, ["---"] * len(head), *rows]
    return "\n".join("| " + " | ".join(line) + " |" for line in lines)


def milliseconds(seconds):
    return f"{1e3 * seconds:,.0f} ms" if seconds >= 0.1 else f"{1e3 * seconds:.2g} ms"


def microseconds(seconds):
    return f"{1e6 * seconds:.1f} µs"


def log_to_path_table(figures):
    runs = figures["log_to_path"]
    names = {"1000000": "rows over the surface", "scan_lines": "rows along the scan's lines", "10000000": "rows over the surface"}
    rows = [[f"{runs[key]['samples']:,}", name, f"{runs[key]['wall_s']:.2f} s",
             *(milliseconds(runs[key]["stages_s"][stage]) for stage in ("read", "scan", "fit", "path")),
             f"{1e-6 * runs[key]['memory_bytes']:.0f} MB"] for key, name in names.items()]
    return table(["samples", "path", "whole command", "read", "scan", "fit", "path", "memory"], rows)


def normals_table(figures):
    def row(name, threads, entry, time="real_s"):
        return [name, str(threads), milliseconds(entry[time]), f"{entry['mean_deg']:.4f}°", f"{entry['max_deg']:.2f}°"]

    found = figures["benchmarks"]
    rows = [row(f"ours, line fit included", threads, found[name]) for threads, name in OURS.items()]
    rows.append(row("ours, also finding rows and filtering", 1, found["cloudToNormals/0"]))
    for omp in (False, True):
        rows += [row(f"PCL{' OMP' if omp else ''}, k = {k}, tree included", 2 if omp else 1, entry)
                 for k, entry in pcl(figures, omp).items() if k >= 50]
    return table(["normals of 1,000,125 points", "threads", "time", "mean error", "largest"], rows)


def kernels_table(figures):
    found = figures["benchmarks"]
    rows = []
    for n in (20000, 200000):
        plain = found[f"curveCalibrationAndReference/{n}"]
        rows.append([f"cubic least squares, {n:,} points, {n // 10:,} control points", milliseconds(found[f"curveLeastSquares/{n}"]["real_s"]),
                     f"textbook loop {milliseconds(plain['real_s'])}, Eigen sparse LDLT {milliseconds(found[f'curveEigenSimplicialLdlt/{n}']['real_s'])}, "
                     f"SciPy banded {milliseconds(plain['reference_figure_scipy_banded_s'])} (reference figure)"])
    for kind in ("warm", "cold"):
        def solved(name):
            entry = found[f"inverse{name}/{kind}"]
            return f"{microseconds(entry['real_s'])}, {entry['solved_percent']:.1f} % solved"
        rows.append([f"inverse kinematics, {'along a path' if kind == 'warm' else 'from zero'}", solved("Ours"),
                     f"KDL NR_JL {solved('Newton')}; KDL LMA {solved('Lma')}"])
    return table(["work", "ours", "others"], rows)


def tables(figures):
    """Figures by the name of their place in the documents."""
    k, reaches = rival(figures, False)
    comparison = f"as accurate from k = {k} on" if reaches else f"at no k ≤ {NEIGHBOURS[-1]} as accurate, best at k = {k}"
    summary = (f"{figures['processor']}, {figures['cores']} cores. PCL is {comparison}; there it takes {gain(figures, False):.0f} × our time on one "
               f"thread, {gain(figures, True):.0f} × on two. Ten million samples take {growth(figures):.2f} × the time per sample of one million.")
    return {"log_to_path": log_to_path_table(figures), "normals": normals_table(figures), "kernels": kernels_table(figures), "machine": summary}


def text(figures):
    return "\n\n".join(tables(figures).values())
