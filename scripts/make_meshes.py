#!/usr/bin/env python3
"""Writes the meshes of models/axel and models/axel/station (OBJ, metres, faces counter-clockwise from
outside). Python's standard library only; the same bytes every time. Run from anywhere:

    scripts/make_meshes.py            writes them
    scripts/make_meshes.py --check    says which committed file differs, exit 1 if one does

Dimensions are those of models/axel/axel.yaml, models/axel/station/station.yaml and their URDF files.
"""

import math
import os
import sys

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))


class Mesh:
    """Vertices and triangles; every part has its own vertices, so edges shade sharp."""

    def __init__(self):
        self.vertices = []
        self.triangles = []

    def add(self, vertices, polygons):
        first = len(self.vertices)
        self.vertices += vertices
        for polygon in polygons:
            for k in range(1, len(polygon) - 1):
                self.triangles.append(
                    (first + polygon[0], first + polygon[k], first + polygon[k + 1]))
        return self

    def box(self, low, high):
        vertices = [((low, high)[i][0], (low, high)[j][1], (low, high)[k][2])
                    for k in (0, 1) for j in (0, 1) for i in (0, 1)]
        return self.add(vertices, [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4),
                                   (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)])

    def turned(self, profile, axis, sides, centre=(0.0, 0.0, 0.0), inward=False):
        """Surface of revolution about the axis ("x" or "y") of a profile of (place along the axis,
        radius), seen from outside when the place grows; each stretch has its own vertices."""
        def point(along, radius, i):
            angle = 2.0 * math.pi * i / sides
            u, v = radius * math.cos(angle), radius * math.sin(angle)
            p = (along, u, v) if axis == "x" else (v, along, u)
            return tuple(p[k] + centre[k] for k in range(3))

        for (a, ra), (b, rb) in zip(profile, profile[1:]):
            vertices = [point(a, ra, i) for i in range(sides)]
            vertices += [point(b, rb, i) for i in range(sides)]
            polygons = []
            for i in range(sides):
                k = (i + 1) % sides
                quad = (i, k, sides + k, sides + i)
                if ra == 0.0:
                    quad = (i, sides + k, sides + i)
                elif rb == 0.0:
                    quad = (i, k, sides + i)
                polygons.append(tuple(reversed(quad)) if inward else quad)
            self.add(vertices, polygons)
        return self

    def cylinder(self, axis, low, high, radius, sides, centre=(0.0, 0.0, 0.0)):
        return self.turned([(low, 0.0), (low, radius), (high, radius), (high, 0.0)], axis, sides,
                           centre)

    def text(self, name):
        lines = ["# %s, made by scripts/make_meshes.py" % name, "o " + name]
        lines += ["v %.6g %.6g %.6g" % tuple(x + 0.0 for x in v) for v in self.vertices]
        lines += ["f %d %d %d" % tuple(i + 1 for i in t) for t in self.triangles]
        return "\n".join(lines) + "\n"


def body():
    """Frame R. Nothing reaches beyond x = 0.119 m near the cameras, which look out of x = 0.12."""
    mesh = Mesh()
    mesh.cylinder("y", -0.28, 0.28, 0.16, 40, (-0.042, 0.0, -0.022))  # housing
    for side in (-1.0, 1.0):  # in halves: the arm goes round between them
        mesh.cylinder("y", 0.035 if side > 0 else -0.115, 0.115 if side > 0 else -0.035, 0.09, 32,
                      (-0.14, 0.0, 0.0))  # spool's motor and batteries
        mesh.cylinder("y", 0.28 if side > 0 else -0.36, 0.36 if side > 0 else -0.28, 0.035, 24)
    return mesh


def body_coaxial():
    """As body, all on the axle: the housing's halves, and between them the spool and the arm's root."""
    mesh = Mesh()
    mesh.cylinder("y", -0.10, 0.10, 0.09, 32)
    for side in (-1.0, 1.0):
        mesh.cylinder("y", 0.10 if side > 0 else -0.28, 0.28 if side > 0 else -0.10, 0.16, 40)
        mesh.cylinder("y", 0.28 if side > 0 else -0.36, 0.36 if side > 0 else -0.28, 0.035, 24)
    return mesh


def camera_heads():
    mesh = Mesh()
    for side in (-1.0, 1.0):
        mesh.box((0.0475, side * 0.175 - 0.032, 0.198), (0.1125, side * 0.175 + 0.032, 0.242))
        mesh.cylinder("x", 0.1125, 0.1175, 0.020, 20, (0.0, side * 0.175, 0.22))
    return mesh


def camera_posts():
    """Under the heads, from inside the housing: they follow the heads (models/axel/urdf_agreement.h)."""
    mesh = Mesh()
    for side in (-1.0, 1.0):
        mesh.box((0.065, side * 0.175 - 0.012, 0.09), (0.09, side * 0.175 + 0.012, 0.20))
    return mesh


def arm():
    """Frame A: tube, a collar with its lead-in, then the flat-nosed disc with a 2 mm edge."""
    mesh = Mesh()
    mesh.turned([(0.0, 0.0), (0.0, 0.0225), (0.885, 0.0225), (0.885, 0.0300), (0.925, 0.0300),
                 (0.95, 0.0227), (0.95, 0.0225), (0.992, 0.0225)], "x", 24)
    mesh.turned([(0.992, 0.0225), (0.992, 0.0312), (0.998, 0.0312), (1.0, 0.0292), (1.0, 0.0)],
                "x", 24)
    return mesh


def wheel():
    """Frame K: rim, dished discs, hub; first paddle along x."""
    mesh = Mesh()
    mesh.turned([(-0.05, 0.0), (-0.05, 0.225), (-0.075, 0.245), (-0.075, 0.265), (0.075, 0.265),
                 (0.075, 0.245), (0.05, 0.225), (0.05, 0.0)], "y", 48)
    mesh.cylinder("y", -0.07, 0.07, 0.06, 24)
    return mesh


def paddles():
    mesh = Mesh()
    for i in range(12):
        angle = 2.0 * math.pi * i / 12
        c, s = math.cos(angle), math.sin(angle)
        plate = Mesh().box((0.258, -0.075, -0.005), (0.300, 0.075, 0.005))
        # Turned about +y: x towards -z.
        turned = [(c * x + s * z, y, -s * x + c * z) for x, y, z in plate.vertices]
        first = len(mesh.vertices)
        mesh.vertices += turned
        mesh.triangles += [tuple(first + i for i in t) for t in plate.triangles]
    return mesh


def module():
    """Frame M, the mouth's centre. Four walls round the cone's channel, the rear, a top box. The
    front is 5 mm behind the mouth plane, in which the board is."""
    mesh = Mesh()
    front, channel, rear, half, low, high, hole = -0.005, -0.40, -0.80, 0.475, -0.26, 0.43, 0.12
    mesh.box((channel, hole, low), (front, half, high))
    mesh.box((channel, -half, low), (front, -hole, high))
    mesh.box((channel, -hole, hole), (front, hole, high))
    mesh.box((channel, -hole, low), (front, hole, -hole))
    mesh.box((rear, -half, low), (channel, half, high))
    mesh.box((-0.70, -0.25, high), (-0.35, 0.25, high + 0.08))
    return mesh


def cone_face():
    """The flat annulus round the mouth, 1.5 mm proud of the board's plane so that it is drawn."""
    return Mesh().turned([(-0.005, 0.120), (-0.005, 0.170), (0.0015, 0.170), (0.0015, 0.120),
                          (-0.005, 0.120)], "x", 48)


def cone():
    """Funnel, socket and the socket's dark end, seen from inside."""
    return Mesh().turned([(-0.36, 0.0), (-0.36, 0.0320), (-0.12, 0.0320), (-0.004, 0.120)], "x", 48,
                         inward=True)


def stand():
    """Frame S: four legs with round pads; their upper ends are inside the tipped module."""
    mesh = Mesh()
    for x in (-0.65, -0.15):
        for y in (-0.25, 0.25):
            mesh.box((x - 0.02, y - 0.02, 0.01), (x + 0.02, y + 0.02, 0.22))
            pad = Mesh().cylinder("x", 0.0, 0.015, 0.06, 20)
            # From the x axis to the z axis, keeping the handedness.
            vertices = [(x + q, y + r, p) for p, q, r in pad.vertices]
            first = len(mesh.vertices)
            mesh.vertices += vertices
            mesh.triangles += [tuple(first + i for i in t) for t in pad.triangles]
    return mesh


FILES = {
    "models/axel/meshes/body.obj": body,
    "models/axel/meshes/body_coaxial.obj": body_coaxial,
    "models/axel/meshes/camera_heads.obj": camera_heads,
    "models/axel/meshes/camera_posts.obj": camera_posts,
    "models/axel/meshes/arm.obj": arm,
    "models/axel/meshes/wheel.obj": wheel,
    "models/axel/meshes/paddles.obj": paddles,
    "models/axel/station/meshes/module.obj": module,
    "models/axel/station/meshes/cone_face.obj": cone_face,
    "models/axel/station/meshes/cone.obj": cone,
    "models/axel/station/meshes/stand.obj": stand,
}


def main():
    check = sys.argv[1:] == ["--check"]
    if sys.argv[1:] and not check:
        sys.exit(__doc__)
    differ = []
    for name, make in FILES.items():
        path = os.path.join(ROOT, name)
        text = make().text(os.path.splitext(os.path.basename(name))[0])
        if check:
            with open(path, encoding="ascii") as file:
                if file.read() != text:
                    differ.append(name)
            continue
        os.makedirs(os.path.dirname(path), exist_ok=True)
        with open(path, "w", encoding="ascii") as file:
            file.write(text)
    if differ:
        sys.exit("differs from what this script makes: " + ", ".join(differ))


if __name__ == "__main__":
    main()
