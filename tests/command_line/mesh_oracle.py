# SPDX-FileCopyrightText: 2026 scan_to_path developers
# SPDX-License-Identifier: Apache-2.0
"""A triangle mesh and what can be asked of it, by brute force over a plain grid. Shares nothing with the package."""
import csv
import math
import struct

SIZES = {"char": "b", "uchar": "B", "short": "h", "ushort": "H", "int": "i", "uint": "I", "float": "f", "double": "d"}


def read_ply(path, scale=1.0):
    """Vertices [m] and triangles of a binary little-endian PLY whose faces are triangles."""
    header, body = path.read_bytes().split(b"end_header\n", 1)
    counts, vertex_types, face_types, element = {}, [], None, None
    for words in (line.split() for line in header.decode().splitlines()):
        if words[0] == "element":
            element = words[1]
            counts[element] = int(words[2])
        elif words[0] == "property" and element == "vertex":
            vertex_types.append(SIZES[words[1]])
        elif words[0] == "property" and element == "face":
            face_types = SIZES[words[2]], SIZES[words[3]]
    record = struct.Struct("<" + "".join(vertex_types))
    vertices = [tuple(scale * value for value in record.unpack_from(body, i * record.size)[:3])
                for i in range(counts["vertex"])]
    face = struct.Struct("<" + face_types[0] + 3 * face_types[1])
    at = record.size * counts["vertex"]
    triangles = []
    for count, *corners in (face.unpack_from(body, at + i * face.size) for i in range(counts["face"])):
        if count != 3:
            raise ValueError(f"{path.name}: a face of {count} corners")
        triangles.append(tuple(corners))
    return vertices, triangles


def read_ascii_stl(path, scale=1.0):
    """Vertices [m], each once, and triangles of a text STL; triangles without area are left away."""
    corners = [tuple(scale * float(word) for word in line.split()[1:])
               for line in path.read_text().splitlines() if line.split()[:1] == ["vertex"]]
    numbers = {}
    triangles = [tuple(numbers.setdefault(corner, len(numbers)) for corner in corners[i:i + 3])
                 for i in range(0, len(corners), 3)]
    return list(numbers), [triangle for triangle in triangles if len(set(triangle)) == 3]


def minus(a, b):
    return a[0] - b[0], a[1] - b[1], a[2] - b[2]


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def nearest_on_segment(p, a, b):
    along, to = minus(b, a), minus(p, a)
    length = dot(along, along)
    share = min(1.0, max(0.0, dot(to, along) / length)) if length > 0.0 else 0.0
    return a[0] + share * along[0], a[1] + share * along[1], a[2] + share * along[2]


def distance_to_segment(p, a, b):
    return math.dist(p, nearest_on_segment(p, a, b))


def distance_to_triangle(p, a, b, c):
    """To the plane where the foot of the perpendicular lies in the triangle, else to the nearest side."""
    u, v, w = minus(b, a), minus(c, a), minus(p, a)
    uu, uv, vv, wu, wv = dot(u, u), dot(u, v), dot(v, v), dot(w, u), dot(w, v)
    area = uu * vv - uv * uv
    if area > 0.0:
        s, t = (wu * vv - wv * uv) / area, (wv * uu - wu * uv) / area
        if s >= 0.0 and t >= 0.0 and s + t <= 1.0:
            return math.dist(p, [a[k] + s * u[k] + t * v[k] for k in range(3)])
    return min(distance_to_segment(p, a, b), distance_to_segment(p, b, c), distance_to_segment(p, c, a))


def is_inside(x, y, loop):
    """Whether a point of the x-y plane lies in a closed polygon."""
    inside = False
    for (ax, ay, *_), (bx, by, *_) in zip(loop, loop[1:] + loop[:1]):
        if (ay > y) != (by > y) and x < ax + (y - ay) * (bx - ax) / (by - ay):
            inside = not inside
    return inside


class Cells:
    """Things by the cells of the x-y plane that their boxes, grown by `reach`, touch."""

    def __init__(self, size, reach):
        self.size, self.reach, self.cells = size, reach, {}

    def cell(self, x, y):
        return math.floor(x / self.size), math.floor(y / self.size)

    def add(self, thing, points):
        low = self.cell(min(p[0] for p in points) - self.reach, min(p[1] for p in points) - self.reach)
        high = self.cell(max(p[0] for p in points) + self.reach, max(p[1] for p in points) + self.reach)
        for i in range(low[0], high[0] + 1):
            for j in range(low[1], high[1] + 1):
                self.cells.setdefault((i, j), []).append(thing)

    def near(self, x, y):
        return self.cells.get(self.cell(x, y), ())


class Mesh:
    """Distances are exact up to `reach` [m]; what is farther is math.inf away."""

    def __init__(self, vertices, triangles, reach=0.002):
        self.vertices, self.triangles, self.reach = vertices, triangles, reach
        self.cells = Cells(reach, reach)
        for triangle in triangles:
            corners = tuple(vertices[i] for i in triangle)
            self.cells.add(corners, corners)

    def distance(self, p):
        nearest = min((distance_to_triangle(p, *corners) for corners in self.cells.near(p[0], p[1])), default=math.inf)
        return nearest if nearest <= self.reach else math.inf

    def top(self, x, y):
        """Highest z over (x, y), which is what a beam along -z meets; None beside the mesh."""
        highest = None
        for a, b, c in self.cells.near(x, y):
            area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
            if area == 0.0:
                continue
            s = ((x - a[0]) * (c[1] - a[1]) - (y - a[1]) * (c[0] - a[0])) / area
            t = ((b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0])) / area
            if s < 0.0 or t < 0.0 or s + t > 1.0:
                continue
            z = a[2] + s * (b[2] - a[2]) + t * (c[2] - a[2])
            highest = z if highest is None else max(highest, z)
        return highest

    def holes(self):
        """Boundary loops but the longest, each as its vertices in order."""
        sides = {(a, b) for i, j, k in self.triangles for a, b in ((i, j), (j, k), (k, i))}
        following = {}
        for a, b in sides:
            if (b, a) not in sides:
                following.setdefault(a, []).append(b)
        loops = []
        while following:
            loop, at = [], next(iter(following))
            while at in following:
                loop.append(self.vertices[at])
                ahead = following[at].pop()
                if not following[at]:
                    del following[at]
                at = ahead
            loops.append(loop)
        loops.sort(key=lambda loop: sum(math.dist(p, q) for p, q in zip(loop, loop[1:] + loop[:1])))
        return loops[:-1]

    def area_points(self, spacing):
        """Points on top of the mesh over a square grid of the x-y plane."""
        low = [min(v[k] for v in self.vertices) for k in range(2)]
        count = [int((max(v[k] for v in self.vertices) - low[k]) / spacing) for k in range(2)]
        for i in range(count[0]):
            for j in range(count[1]):
                x, y = low[0] + (i + 0.5) * spacing, low[1] + (j + 0.5) * spacing
                z = self.top(x, y)
                if z is not None:
                    yield x, y, z


def section(mesh, y):
    """The mesh's lines in a plane across the y axis."""
    for triangle in mesh.triangles:
        corners = [mesh.vertices[i] for i in triangle]
        if not min(c[1] for c in corners) < y < max(c[1] for c in corners):
            continue
        ends = [tuple(a[k] + (y - a[1]) / (b[1] - a[1]) * (b[k] - a[k]) for k in range(3))
                for a, b in zip(corners, corners[1:] + corners[:1]) if (a[1] - y) * (b[1] - y) < 0.0]
        if len(ends) == 2:
            yield tuple(ends)


class SeenRows:
    """What a scan in rows along x, each at one y, saw of a mesh: its lines over the rows, as far as they face up."""

    SIDE = 0.005  # [m] of the stretches of x that lines are looked up by
    HIDDEN = 1e-5  # [m] below the mesh's top: rounding is less, an overhang more

    def __init__(self, mesh, rows):
        self.mesh, self.rows, self.lines = mesh, rows, [{} for _ in rows]
        for row, y in zip(self.lines, rows):
            for line in section(mesh, y):
                low, high = sorted(math.floor(end[0] / self.SIDE) for end in line)
                for stretch in range(low, high + 1):
                    row.setdefault(stretch, set()).add(line)

    def is_seen(self, p):
        top = self.mesh.top(p[0], p[1])
        return top is not None and top - p[2] <= self.HIDDEN

    def depth(self, centre, radius):
        """How deep a ball goes in at most [m]; 0 where it does not."""
        deepest = 0.0
        low, high = (math.floor((centre[0] + way) / self.SIDE) for way in (-radius, radius))
        for y, row in zip(self.rows, self.lines):
            if abs(y - centre[1]) >= radius:
                continue
            for line in (line for stretch in range(low, high + 1) for line in row.get(stretch, ())):
                nearest = nearest_on_segment(centre, *line)
                depth = radius - math.dist(centre, nearest)
                if depth > deepest and self.is_seen(nearest):
                    deepest = depth
        return deepest


def ball_centres(moves, radius, spacing=1e-3):
    """Where a ball's centre is on the moves, their ends included."""
    return places([tuple((tuple(p[k] + radius * n[k] for k in range(3)), n) for p, n in move) for move in moves],
                  spacing)


def rotated_z(x, y, z, w):
    """Third column of a quaternion's rotation: the contact frame's normal."""
    return 2.0 * (x * z + w * y), 2.0 * (y * z - w * x), 1.0 - 2.0 * (x * x + y * y)


def worked_moves(text, origin):
    """Contacts (point, normal) at both ends of every move with the tool at work, less the part's place."""
    rows = csv.DictReader(line for line in text.splitlines() if not line.startswith("#"))
    before = None
    for row in rows:
        point = tuple(float(row[axis]) - origin[k] for k, axis in enumerate("xyz"))
        normal = rotated_z(*(float(row["q" + axis]) for axis in "xyzw"))
        if row["process_on"] == "1":
            yield before, (point, normal)
        before = point, normal


def places(moves, spacing=1e-3):
    """Points of the straight moves, their ends included, each once."""
    last = None
    for (a, _), (b, _) in moves:
        count = max(1, math.ceil(math.dist(a, b) / spacing))
        for k in range(0 if a != last else 1, count + 1):
            yield tuple(a[axis] + (b[axis] - a[axis]) * k / count for axis in range(3))
        last = b


def uncut_share(mesh, moves, radius, reach, height, spacing=2.5e-3):
    """Share of the mesh's upper side over which a ball along the moves leaves more than `height`, to first order in the
    slopes. `reach`: how far beside its contacts a row counts."""
    centre_moves = Cells(reach, reach)
    for move in moves:
        centres = tuple(tuple(p[k] + radius * n[k] for k in range(3)) for p, n in move)
        centre_moves.add(centres, [p for p, _ in move])  # by its contacts: what covers a place is near it
    points = list(mesh.area_points(spacing))
    uncut = sum(1 for p in points if not any(distance_to_segment(p, *move) <= radius + height
                                             for move in centre_moves.near(p[0], p[1])))
    return uncut / len(points)
