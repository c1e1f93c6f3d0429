"""The smallest sphere, box, z-aligned box and capsule about a set of points, each with a certificate or a bound.

    hull_points   the points that matter to any of them, for sets of any rank
    min_ball      exact smallest enclosing ball, in two or three dimensions
    min_box       smallest box, with a certified lower bound
    min_z_box     smallest box with one axis along z, exact
    min_capsule   best known capsule, with a lower bound

Points are rows. A box is (volume, centre, axes as rows, half-extents), a capsule (volume, start, end, radius).
"""
import itertools
import math

import numpy as np
from numba import njit
from scipy.optimize import differential_evolution, minimize, minimize_scalar
from scipy.spatial import ConvexHull


def unit(v):
    return v / np.linalg.norm(v)


def rank_of(points):
    """0 a point, 1 a line, 2 a plane, 3 space; by singular values, to 1e-9 of the largest. (rank, directions as rows)"""
    # three rows of zeros: with fewer than three points, too, there are three directions
    _, s, directions = np.linalg.svd(np.vstack([points - points.mean(0), np.zeros((3, 3))]), full_matrices=False)
    size = max(s.max(initial=0.0), 1e-300)
    if size <= 1e-12 * max(np.abs(points).max(), 1e-300):
        return 0, directions
    return int((s > 1e-9 * size).sum()), directions


def hull_points(points):
    points = np.unique(points, axis=0)
    rank, directions = rank_of(points) if len(points) > 1 else (0, np.eye(3))
    if rank == 0:
        return points[:1]
    along = (points - points[0]) @ directions[:rank].T
    if rank == 1:
        return points[[int(along.argmin()), int(along.argmax())]]
    return points[ConvexHull(along if rank == 2 else points).vertices]


# ---------------------------------------------------------------------------------------------------------- ball
def _ball_through(points):
    """(centre, radius) of the smallest ball with all of these on its surface, or None when they depend on each other"""
    a = points[1:] - points[0]
    if len(a) == 0:
        return points[0], 0.0
    gram = a @ a.T
    if np.linalg.matrix_rank(gram, tol=1e-14 * max(gram.max(), 1e-300)) < len(a):
        return None
    centre = points[0] + np.linalg.solve(2 * gram, np.diag(gram)) @ a
    return centre, np.linalg.norm(centre - points[0])


def min_ball(points):
    """(centre, radius, certificate): the farthest point joins the support set until none is outside. The certificate
    is (how far the farthest point sticks out, how far the centre is from the hull of the support), both relative to
    the radius; the ball is the smallest when both are 0."""
    origin = points.mean(0)                                   # far from it, rounding would decide
    points = points - origin
    support = [0]
    centre, radius = points[0], 0.0
    for _ in range(1000):
        distance = np.linalg.norm(points - centre, axis=1)
        far = int(np.argmax(distance))
        if distance[far] <= radius * (1 + 1e-13) or far in support:
            break
        candidates = support + [far]
        best = None
        for k in range(1, min(len(candidates), points.shape[1] + 1) + 1):
            for chosen in itertools.combinations(candidates, k):
                ball = _ball_through(points[list(chosen)]) if far in chosen else None
                if ball is None or (best and ball[1] >= best[1]):
                    continue
                if np.linalg.norm(points[candidates] - ball[0], axis=1).max() <= ball[1] * (1 + 1e-12) + 1e-300:
                    best = (ball[0], ball[1], list(chosen))
        centre, radius, support = best
    s = points[support] - centre
    k = len(s)
    kkt = np.block([[s @ s.T, np.ones((k, 1))], [np.ones((1, k)), np.zeros((1, 1))]])
    weights = np.linalg.lstsq(kkt, np.r_[np.zeros(k), 1.0], rcond=None)[0][:k]
    off_hull = np.linalg.norm(np.clip(weights, 0, None) @ s)
    excess = np.linalg.norm(points - centre, axis=1).max() - radius
    return centre + origin, max(radius, radius + excess), (max(excess, 0) / (radius or 1), off_hull / (radius or 1))


# ----------------------------------------------------------------------------------------------------- rectangle
@njit(cache=True)
def _planar_hull(x, y):
    """Indices of the convex hull, counter-clockwise, by the monotone chain."""
    n = len(x)
    order = np.argsort(x)
    i = 0
    while i < n:                                              # equal x: by y
        j = i
        while j + 1 < n and x[order[j + 1]] == x[order[i]]:
            j += 1
        if j > i:
            same = order[i:j + 1]
            order[i:j + 1] = same[np.argsort(y[same])]
        i = j + 1
    hull = np.empty(2 * n + 1, np.int64)
    k = 0
    lowest = 2
    for step in range(2 * n - 1):                             # up along the lower chain, back along the upper
        if step == n:
            lowest = k + 1
        i = order[step] if step < n else order[2 * n - 2 - step]
        while k >= lowest:
            a, b = hull[k - 2], hull[k - 1]
            if (x[b] - x[a]) * (y[i] - y[a]) - (y[b] - y[a]) * (x[i] - x[a]) > 0:
                break
            k -= 1
        hull[k] = i
        k += 1
    return hull[:k - 1] if k > 1 else hull[:1]


@njit(cache=True)
def min_rectangle(x, y):
    """(area, angle of one side, length of that side, of the other); one side of the smallest is on a hull edge"""
    h = _planar_hull(x, y)
    m = len(h)
    if m < 3:
        a, b = h[0], h[m - 1]
        return 0.0, math.atan2(y[b] - y[a], x[b] - x[a]), math.hypot(x[b] - x[a], y[b] - y[a]), 0.0
    best, angle, width, height = np.inf, 0.0, 0.0, 0.0
    for i in range(m):
        a, b = h[i], h[(i + 1) % m]
        dx, dy = x[b] - x[a], y[b] - y[a]
        length = math.hypot(dx, dy)
        if length == 0:
            continue
        dx /= length
        dy /= length
        low, high, top = np.inf, -np.inf, -np.inf
        for s in range(m):
            p = h[s]
            along = dx * (x[p] - x[a]) + dy * (y[p] - y[a])
            off = -dy * (x[p] - x[a]) + dx * (y[p] - y[a])
            low = min(low, along)
            high = max(high, along)
            top = max(top, off)
        if (high - low) * top < best:
            best, angle, width, height = (high - low) * top, math.atan2(dy, dx), high - low, top
    return best, angle, width, height


# ----------------------------------------------------------------------------------------------------------- box
@njit(cache=True)
def _frame(n):
    """Two unit vectors perpendicular to the unit vector n."""
    k = 0
    if abs(n[1]) < abs(n[k]):
        k = 1
    if abs(n[2]) < abs(n[k]):
        k = 2
    e = np.zeros(3)
    e[k] = 1.0
    u = np.cross(n, e)
    u /= np.sqrt((u * u).sum())
    return u, np.cross(n, u)


@njit(cache=True)
def _box_about(points, n):
    """The smallest box with one axis along n: (volume, extent along n, rectangle across it as min_rectangle has it)"""
    n = np.ascontiguousarray(n)
    u, v = _frame(n)
    w = points @ n
    area, angle, width, height = min_rectangle(points @ u, points @ v)
    extent = w.max() - w.min()
    return extent * area, extent, area, angle, width, height


@njit(cache=True)
def _evaluate_arcs(points, na, nb, omega, arc, t0, t1, volume, low):
    """For the pieces [t0, t1] of arcs: the volume at the middle and a lower bound over the whole piece, from how fast
    extents can shrink as the normal turns."""
    for s in range(len(arc)):
        k = arc[s]
        o = omega[k]
        t = 0.5 * (t0[s] + t1[s])
        n = (math.sin((1 - t) * o) * na[k] + math.sin(t * o) * nb[k]) / math.sin(o)
        n /= math.sqrt((n * n).sum())
        v, extent, area, _, width, height = _box_about(points, n)
        volume[s] = v
        turn = 0.5 * (t1[s] - t0[s]) * o
        tangent = nb[k] - (nb[k] @ n) * n
        if (tangent * tangent).sum() < 1e-20:
            tangent = n * (na[k] @ n) - na[k]
        tangent /= math.sqrt((tangent * tangent).sum())
        q = points @ tangent
        across = q.max() - q.min()
        least_extent = math.cos(turn) * extent - math.sin(turn) * across
        e = math.sin(turn) * extent + (1 - math.cos(turn)) * across
        # any planar extents (a, b) have ab >= area, both <= diagonal and so both >= area / diagonal:
        # (a - e)(b - e) >= area - 2 e diagonal + e^2, as long as e < area / diagonal
        diagonal = math.sqrt(width * width + height * height)
        least_area = area - 2 * e * diagonal + e * e
        low[s] = least_extent * least_area if least_extent > 0 and least_area > 0 and e * diagonal < area else 0.0


def box_along(points, axes):
    q = points @ axes.T
    low, high = q.min(0), q.max(0)
    return float(np.prod(high - low)), ((low + high) / 2) @ axes, axes, (high - low) / 2


def _axes_about(points, n):
    n = unit(n)
    u, v = _frame(n)
    angle = _box_about(points, n)[3]
    a = unit(math.cos(angle) * u + math.sin(angle) * v)
    return np.array([n, a, np.cross(n, a)])


def min_box(points, tolerance=1e-5, budget=3_000_000):
    """(volume, centre, axes, half-extents, certified lower bound of the volume) of points that span space.

    O'Rourke (1985): some smallest box has two adjacent faces that each hold an edge of the hull. So one of its axes is
    a normal on the arc between the normals of two neighbouring faces of the hull, and with that axis given the best
    rectangle is exact. Branch and bound over all arcs, down to the relative tolerance or the budget of evaluations;
    then a local polish."""
    hull = ConvexHull(points)
    normals = hull.equations[:, :3]
    arcs = np.array([(i, j) for i, around in enumerate(hull.neighbors) for j in around if i < j])
    na, nb = normals[arcs[:, 0]], normals[arcs[:, 1]]
    omega = np.arctan2(np.linalg.norm(np.cross(na, nb), axis=1), (na * nb).sum(1))
    keep = omega > 1e-9
    na, nb, omega = na[keep], nb[keep], omega[keep]
    hv = np.ascontiguousarray(points[hull.vertices])

    def at(k, t):
        return unit((math.sin((1 - t) * omega[k]) * na[k] + math.sin(t * omega[k]) * nb[k]) / math.sin(omega[k]))

    best = box_along(hv, np.eye(3))
    for n in np.unique(np.round(normals, 12), axis=0):
        if _box_about(hv, unit(n))[0] < best[0]:
            best = min(best, box_along(hv, _axes_about(hv, n)), key=lambda b: b[0])
    pieces = np.maximum(1, np.ceil(omega / math.radians(2.0)).astype(int))
    arc = np.repeat(np.arange(len(omega)), pieces)
    index = np.concatenate([np.arange(k) for k in pieces])
    t0, t1 = index / pieces[arc], (index + 1) / pieces[arc]
    evaluations, floor, promising = 0, math.inf, []
    while len(arc):
        volume, low = np.empty(len(arc)), np.empty(len(arc))
        _evaluate_arcs(hv, na, nb, omega, arc, t0, t1, volume, low)
        evaluations += len(arc)
        promising += [(volume[s], arc[s], t0[s], t1[s]) for s in np.argsort(volume)[:8]]
        s = int(np.argmin(volume))
        if volume[s] < best[0]:
            best = min(best, box_along(hv, _axes_about(hv, at(arc[s], 0.5 * (t0[s] + t1[s])))), key=lambda b: b[0])
        live = low < best[0] * (1 - tolerance)
        if (~live).any():
            floor = min(floor, low[~live].min())
        arc, t0, t1, low = arc[live], t0[live], t1[live], low[live]
        if len(arc) and evaluations + 2 * len(arc) > budget:
            floor = min(floor, low.min())
            break
        middle = 0.5 * (t0 + t1)
        arc, t0, t1 = np.r_[arc, arc], np.r_[t0, middle], np.r_[middle, t1]
    for _, k, a, b in sorted(promising, key=lambda c: c[0])[:24]:
        width = max(b - a, 1e-4)
        found = minimize_scalar(lambda t: _box_about(hv, at(k, t))[0], method="bounded",
                                bounds=(max(0, a - width), min(1, b + width)), options=dict(xatol=1e-12))
        best = min(best, box_along(hv, _axes_about(hv, at(k, found.x))), key=lambda b: b[0])
    for _ in range(50):
        again = min((box_along(hv, _axes_about(hv, n)) for n in best[2]), key=lambda b: b[0])
        if again[0] >= best[0] * (1 - 1e-15):
            break
        best = again
    return *best, min(floor, best[0])


def min_z_box(points):
    return box_along(points, _axes_about(np.ascontiguousarray(points), np.array([0.0, 0, 1])))


# ------------------------------------------------------------------------------------------------------- capsule
def ball_volume(radius):
    return 4 / 3 * math.pi * radius ** 3


def capsule_volume(length, radius):
    return math.pi * radius * radius * length + ball_volume(radius)


def distance_to_segment(points, a, b):
    """(distances, parameters in [0, 1], vectors from the segment)"""
    d = b - a
    dd = d @ d
    t = np.clip((points - a) @ d / dd, 0, 1) if dd > 0 else np.zeros(len(points))
    q = points - a - t[:, None] * d
    return np.sqrt((q * q).sum(1)), t, q


def _volume_of_ends(x, points):
    return capsule_volume(np.linalg.norm(x[3:6] - x[:3]), distance_to_segment(points, x[:3], x[3:6])[0].max())


def _capsule_on_line(points, c, d):
    """The smallest capsule whose axis is on the line c + t d."""
    t = (points - c) @ d
    off2 = ((points - c - np.outer(t, d)) ** 2).sum(1)
    least = math.sqrt(off2.max())

    def ends(r):
        s = np.sqrt(np.maximum(r * r - off2, 0))
        low, high = (t + s).min(), (t - s).max()
        return (low, high) if high > low else ((low + high) / 2,) * 2

    def volume(r):
        low, high = ends(r)
        return capsule_volume(high - low, r)
    found = minimize_scalar(volume, bounds=(least, 1.5 * least + 1e-300), method="bounded",
                            options=dict(xatol=1e-10 * least + 1e-300))
    r = found.x if found.fun < volume(least) else least
    low, high = ends(r)
    return volume(r), c + low * d, c + high * d, r


def _capsule_descent(points, a, b):
    """A local optimum over both ends and the radius by sequential quadratic programming; the constraints are the
    farthest points, and whatever point is found outside joins them."""
    scale = np.ptp(points, axis=0).max()
    origin = points.mean(0)
    q, x = (points - origin) / scale, np.r_[a - origin, b - origin] / scale
    distance = distance_to_segment(q, x[:3], x[3:])[0]
    work = set(np.argsort(-distance)[:40].tolist())
    z = np.r_[x, distance.max()]
    low, high = q.min(0) - 0.5, q.max(0) + 0.5
    bounds = list(zip(np.r_[low, low, 0.0], np.r_[high, high, 3.0]))

    def volume(z):
        d = z[3:6] - z[:3]
        length, r = math.sqrt(d @ d + 1e-24), z[6]
        g = math.pi * r * r * d / length
        return capsule_volume(length, r), np.r_[-g, g, 2 * math.pi * r * length + 4 * math.pi * r * r]

    for _ in range(12):
        ids = np.array(sorted(work))

        def room(z):
            return z[6] ** 2 - distance_to_segment(q[ids], z[:3], z[3:6])[0] ** 2

        def room_gradient(z):
            _, t, v = distance_to_segment(q[ids], z[:3], z[3:6])
            return np.column_stack([2 * (1 - t)[:, None] * v, 2 * t[:, None] * v, np.full(len(ids), 2 * z[6])])
        found = minimize(volume, z, jac=True, method="SLSQP", bounds=bounds,
                         constraints=[dict(type="ineq", fun=room, jac=room_gradient)],
                         options=dict(maxiter=200, ftol=1e-14))
        if not np.isfinite(found.x).all():
            break
        z = found.x
        distance = distance_to_segment(q, z[:3], z[3:6])[0]
        new = [int(i) for i in np.argsort(-distance)[:20] if distance[i] > z[6] * (1 + 1e-10) and i not in work]
        if not new:
            break
        work.update(new)
    a, b = z[:3] * scale + origin, z[3:6] * scale + origin
    results = [(_volume_of_ends(np.r_[a, b], points), a, b, distance_to_segment(points, a, b)[0].max())]
    if np.linalg.norm(b - a) > 1e-9 * scale:
        results.append(_capsule_on_line(points, a, unit(b - a)))
    return min(results, key=lambda o: o[0])


def half_sphere_directions(n):
    """n roughly even unit vectors with z > 0."""
    i = np.arange(n) + 0.5
    z = 1 - i / n
    phi = i * math.pi * (3 - math.sqrt(5))
    s = np.sqrt(1 - z * z)
    return np.column_stack([s * np.cos(phi), s * np.sin(phi), z])


def min_capsule(points, axes=np.eye(3), starts=300, keep=16, seed=0):
    """(volume, start, end, radius, lower bound of the volume) of hull points that span a plane or space.

    For many directions the axis through the smallest circle of the projection; the best of these are descended. A
    differential evolution over the six end coordinates, descended too, is a second opinion. The smallest ball is a
    candidate as well.
    Lower bound: an axis along d needs a radius of at least r(d), that of the projection's smallest circle, and, between
    the outermost points of its caps, the width along d. The smallest such volume over 1,000 directions, each of the
    best of them improved locally: an estimate from above of a bound, not a proof."""
    centre, radius, _ = min_ball(points)
    directions = np.vstack([half_sphere_directions(starts), axes, rank_of(points)[1]])

    def circle(d):
        u, v = _frame(d)
        c, r, _ = min_ball(points @ np.column_stack([u, v]))
        return c[0] * u + c[1] * v, r

    def least_volume(d):
        r, width = circle(d)[1], np.ptp(points @ d)
        return capsule_volume(max(0.0, width - 2 * r), r)

    first = sorted((_capsule_on_line(points, circle(d)[0], d) for d in directions), key=lambda o: o[0])
    found = [(ball_volume(radius), centre, centre, radius)]
    found += [_capsule_descent(points, o[1], o[2]) for o in first[:keep]]
    low, high = points.min(0), points.max(0)
    evolved = differential_evolution(_volume_of_ends, list(zip(np.r_[low, low] - 1e-9, np.r_[high, high] + 1e-9)),
                                     args=(points,), seed=seed, popsize=10, maxiter=150, tol=1e-8, polish=False)
    found.append(_capsule_descent(points, evolved.x[:3], evolved.x[3:6]))
    grid = half_sphere_directions(1000)
    least = np.array([least_volume(d) for d in grid])
    bound = least.min()
    for i in np.argsort(least)[:4]:
        u, v = _frame(grid[i])
        near = minimize(lambda w: least_volume(unit(grid[i] + w[0] * u + w[1] * v)), [0, 0], method="Nelder-Mead",
                        options=dict(xatol=1e-6, fatol=1e-12, maxiter=120,
                                     initial_simplex=[[0, 0], [.03, 0], [0, .03]]))
        bound = min(bound, near.fun)
    best = min(found, key=lambda o: o[0])
    return *best, min(bound, best[0])
