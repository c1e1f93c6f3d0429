"""Spheres, capsules and boxes, and the exact signed distance between any two of them.

One idea serves all six pairs of types. A sphere is a point grown by its radius, a capsule a segment grown by its
radius, a box the sum of three segments grown by nothing. So the Minkowski difference A - B is a zonotope

    P = { x1 g1 + x2 g2 + ... : |xi| <= 1 }        (at most six generators g)

grown by the sum R of the radii, and with c = centre of A - centre of B

    signed distance of A and B  =  signed distance of the point c and P  -  R.

Positive is the gap, negative the penetration depth: the length of the shortest translation that separates the two.

- c outside P: the least-squares problem min |c - G x|, |xi| <= 1, by an active-set method, with a certificate from
  duality: for the unit vector u from the solution towards c,  u.c - sum |u.g|  <=  truth  <=  |c - G x|.
- c inside P, possible only when the generators span space: the smallest  sum |n.g| - |n.c|  over the normals
  n = gi x gj of P's faces.

exact_signed_distance does the same in 60-digit arithmetic, by trying every vertex, edge and face of P without any
optimiser. It is what the test vectors hold; the fast one checks it.
"""
import itertools
from dataclasses import dataclass, replace

import mpmath
import numpy as np
from scipy.optimize import lsq_linear


@dataclass(frozen=True)
class Sphere:
    centre: np.ndarray
    radius: float
    kind = "sphere"
    count_of_numbers = 4

    def core(self):
        """(centre, generators as rows, radius)"""
        return self.centre, np.zeros((0, 3)), self.radius

    def bounding_radius(self):
        return self.radius

    def moved(self, by):
        return replace(self, centre=self.centre + by)

    def numbers(self):
        """What a file of test vectors stores, in its order."""
        return [*self.centre, self.radius]

    @classmethod
    def of_numbers(cls, n):
        return cls(np.array(n[0:3], float), float(n[3]))


@dataclass(frozen=True)
class Capsule:
    start: np.ndarray
    end: np.ndarray
    radius: float
    kind = "capsule"
    count_of_numbers = 7

    def core(self):
        return (self.start + self.end) / 2, ((self.end - self.start) / 2)[None, :], self.radius

    def bounding_radius(self):
        return float(np.linalg.norm(self.end - self.start)) / 2 + self.radius

    def moved(self, by):
        return replace(self, start=self.start + by, end=self.end + by)

    def numbers(self):
        return [*self.start, *self.end, self.radius]

    @classmethod
    def of_numbers(cls, n):
        return cls(np.array(n[0:3], float), np.array(n[3:6], float), float(n[6]))


@dataclass(frozen=True)
class Box:
    """quaternion: w, x, y, z, of any length but 0; half: the half-extents along the axes that it gives."""
    centre: np.ndarray
    quaternion: np.ndarray
    half: np.ndarray
    kind = "box"
    count_of_numbers = 10

    def axes(self):
        """The unit axes x, y, z as rows."""
        return np.array(axes_of_quaternion(*(self.quaternion / np.sqrt((self.quaternion ** 2).sum()))))

    def core(self):
        return self.centre, self.axes() * self.half[:, None], 0.0

    def bounding_radius(self):
        return float(np.linalg.norm(self.half))

    def moved(self, by):
        return replace(self, centre=self.centre + by)

    def numbers(self):
        return [*self.centre, *self.quaternion, *self.half]

    @classmethod
    def of_numbers(cls, n):
        return cls(np.array(n[0:3], float), np.array(n[3:7], float), np.array(n[7:10], float))


SHAPES = {c.kind: c for c in (Sphere, Capsule, Box)}


def axes_of_quaternion(w, x, y, z):
    """The columns of the rotation matrix of a unit quaternion: the images of the x, y and z axis."""
    return ([1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y)],
            [2 * (x * y - w * z), 1 - 2 * (x * x + z * z), 2 * (y * z + w * x)],
            [2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y)])


def quaternion_product(p, q):
    """The rotation q followed by the rotation p."""
    return np.array([p[0] * q[0] - p[1] * q[1] - p[2] * q[2] - p[3] * q[3],
                     p[0] * q[1] + p[1] * q[0] + p[2] * q[3] - p[3] * q[2],
                     p[0] * q[2] - p[1] * q[3] + p[2] * q[0] + p[3] * q[1],
                     p[0] * q[3] + p[1] * q[2] - p[2] * q[1] + p[3] * q[0]])


def unit(v):
    return v / np.linalg.norm(v)


# ------------------------------------------------------------------------------------------- double precision
def signed_distance(a, b):
    """(signed distance, how far the certificate leaves it open, unit direction from b to a along which it is taken)"""
    ca, ga, ra = a.core()
    cb, gb, rb = b.core()
    c, g, r = ca - cb, np.vstack([ga, gb]), ra + rb
    scale = max(np.linalg.norm(c), np.abs(g).max() if len(g) else 0, r, 1e-300)
    c, g = c / scale, g / scale
    distance, gap, u = _point_to_zonotope(c, g[np.linalg.norm(g, axis=1) > 1e-14])
    return scale * distance - r, scale * gap, u


def _point_to_zonotope(c, g):
    up = np.array([0.0, 0, 1])
    if len(g) == 0:
        d = np.linalg.norm(c)
        return d, 0.0, (c / d if d > 0 else up)
    best_separation = -np.inf
    if len(g) >= 3:
        i, j = np.triu_indices(len(g), 1)
        n = np.cross(g[i], g[j])
        length = np.linalg.norm(n, axis=1)
        ok = length > 1e-13 * np.linalg.norm(g[i], axis=1) * np.linalg.norm(g[j], axis=1)
        n = n[ok] / length[ok, None]
        reach = np.abs(n @ g.T).sum(1)
        if len(n) and reach.min() > 1e-13:                    # the generators span space
            separation = np.abs(n @ c) - reach
            m = int(np.argmax(separation))
            best_separation = separation[m]
            if best_separation <= 0:
                return best_separation, 0.0, n[m] * (1.0 if n[m] @ c >= 0 else -1.0)
    x = np.clip(lsq_linear(g.T, c, (-1.0, 1.0), method="bvls", tol=1e-16, max_iter=200).x, -1, 1)
    v = c - x @ g
    d = np.linalg.norm(v)
    if d == 0:
        return 0.0, 0.0, up
    u = v / d
    return d, d - max(u @ c - np.abs(g @ u).sum(), best_separation, 0.0), u


# ------------------------------------------------------------------------------------------------- sixty digits
def _dot(p, q):
    return p[0] * q[0] + p[1] * q[1] + p[2] * q[2]


def _plus(p, q, factor):
    return [p[0] + factor * q[0], p[1] + factor * q[1], p[2] + factor * q[2]]


def _cross(p, q):
    return [p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]]


def _exact_core(shape):
    mpf = lambda numbers: [mpmath.mpf(float(x)) for x in numbers]
    if shape.kind == "sphere":
        return mpf(shape.centre), [], mpmath.mpf(float(shape.radius))
    if shape.kind == "capsule":
        p, q = mpf(shape.start), mpf(shape.end)
        return ([(s + t) / 2 for s, t in zip(p, q)], [[(t - s) / 2 for s, t in zip(p, q)]],
                mpmath.mpf(float(shape.radius)))
    q = mpf(shape.quaternion)
    length = mpmath.sqrt(sum(x * x for x in q))
    axes = axes_of_quaternion(*[x / length for x in q])
    return mpf(shape.centre), [[h * x for x in axis] for h, axis in zip(mpf(shape.half), axes)], mpmath.mpf(0)


def exact_signed_distance(a, b, digits=60):
    """The signed distance of the shapes that the stored numbers describe, rounded once, to a double."""
    with mpmath.workdps(digits):
        (ca, ga, ra), (cb, gb, rb) = _exact_core(a), _exact_core(b)
        c, r = _plus(ca, cb, -1), ra + rb
        g = [v for v in ga + gb if _dot(v, v) > 0]
        tiny = mpmath.mpf(10) ** (-digits // 2)
        faces = []
        for i, j in itertools.combinations(range(len(g)), 2):
            n = _cross(g[i], g[j])
            length = mpmath.sqrt(_dot(n, n))
            if length > tiny * mpmath.sqrt(_dot(g[i], g[i]) * _dot(g[j], g[j])):
                n = [x / length for x in n]
                faces.append((i, j, n, sum(abs(_dot(n, v)) for v in g)))
        if faces and min(f[3] for f in faces) > tiny * max(f[3] for f in faces):
            separation = max(abs(_dot(n, c)) - reach for _, _, n, reach in faces)
            if separation <= 0:
                return float(separation - r)
        nearest = None
        for free in [()] + [(i,) for i in range(len(g))] + [f[:2] for f in faces]:
            fixed = [v for i, v in enumerate(g) if i not in free]
            for signs in itertools.product((-1, 1), repeat=len(fixed)):
                w = c
                for s, v in zip(signs, fixed):
                    w = _plus(w, v, -s)
                if len(free) == 1:
                    v = g[free[0]]
                    x = _dot(v, w) / _dot(v, v)
                    if abs(x) > 1:
                        continue
                    w = _plus(w, v, -x)
                elif len(free) == 2:
                    p, q = g[free[0]], g[free[1]]
                    pp, pq, qq, pw, qw = _dot(p, p), _dot(p, q), _dot(q, q), _dot(p, w), _dot(q, w)
                    det = pp * qq - pq * pq
                    x, y = (qq * pw - pq * qw) / det, (pp * qw - pq * pw) / det
                    if abs(x) > 1 or abs(y) > 1:
                        continue
                    w = _plus(_plus(w, p, -x), q, -y)
                d = _dot(w, w)
                nearest = d if nearest is None or d < nearest else nearest
        return float(mpmath.sqrt(nearest) - r)
