"""Simulated angiograms for the training of the vessel network: frame and classes, drawn by a seeded generator.

Independent of the program's own simulator (core/simulation), which judges. Everything is drawn in projection: no 3-D.
Vessels are dark, as the program hands frames to the network.
"""

import cv2
import numpy as np

BACKGROUND, VESSEL, DEVICE, UNSURE = 0, 1, 2, 255
SUPER = 2  # drawn at so many times the size


def _walk(rng, start, angle, length, bend, wave, step=2.0):
    """A smooth random course: its heading drifts and wanders by about `bend` and winds by `wave` (radians)."""
    count = max(4, int(length / step))
    t = np.arange(count) * step
    wander = cv2.GaussianBlur(rng.normal(0, 1, (1, count + 80)), (0, 0), rng.uniform(3, 18)).ravel()[40:-40]
    wander = bend * (wander - wander[0]) / (wander.std() + 0.05)
    drift = rng.normal(0, 1.2 * bend) * t / 100.0
    envelope = np.clip(np.sin(2 * np.pi * t / rng.uniform(60, 300) + rng.uniform(0, 6.3)) + 0.3, 0, 1)
    winding = wave * envelope * np.sin(2 * np.pi * t / rng.uniform(12, 45) + rng.uniform(0, 6.3))
    angles = angle + wander + drift + winding
    return start + np.cumsum(step * np.stack([np.cos(angles), np.sin(angles)], 1), 0), angles


def _radii(rng, count, radius, taper):
    radii = radius * np.linspace(1, taper, count)
    radii *= 1 + 0.08 * cv2.GaussianBlur(rng.normal(0, 3, (1, count)), (0, 0), 6).ravel()
    for _ in range(rng.poisson(0.35)):  # stenoses and, rarely, wide parts
        middle, width = rng.uniform(0, count), rng.uniform(2, 8)
        depth = rng.uniform(0.2, 0.85) if rng.random() < 0.8 else -rng.uniform(0.2, 0.8)
        radii *= 1 - depth * np.exp(-0.5 * ((np.arange(count) - middle) / width) ** 2)
    return np.maximum(radii, 0.3)


def _branch(rng, branches, start, angle, radius, length, style, depth):
    points, angles = _walk(rng, start, angle, length, style["bend"], style["wave"] * min(1.0, 3.0 / radius))
    radii = _radii(rng, len(points), radius, style["taper"])
    branches.append((points, radii))
    if depth <= 0:
        return
    for _ in range(rng.poisson(style["children"] * length / 120.0)):
        i = int(rng.uniform(0.08, 1.0) * (len(points) - 1))
        child = radii[i] * rng.uniform(0.35, 0.9)
        if child < 0.45:
            continue
        side = rng.choice([-1, 1]) * np.radians(rng.uniform(15, 85))
        _branch(rng, branches, points[i], angles[i] + side, child, length * rng.uniform(0.25, 0.9), style, depth - 1)


def _thickness(shape, branches):
    """Length of the ray inside round vessels, px, for one group of branches that do not add up."""
    h, w = shape[0] * SUPER, shape[1] * SUPER
    seeds = np.full((h, w), 255, np.uint8)
    radius_at = np.zeros((h, w), np.float32)
    for points, radii in branches:
        p = np.round(points * SUPER * 16).astype(np.int32)
        for i in range(len(p) - 1):
            a, b = tuple(int(v) for v in p[i]), tuple(int(v) for v in p[i + 1])
            cv2.line(seeds, a, b, 0, 1, cv2.LINE_8, 4)
            cv2.line(radius_at, a, b, float(radii[i]), 1, cv2.LINE_8, 4)
    if seeds.min() > 0:
        return np.zeros(shape, np.float32)
    distance, labels = cv2.distanceTransformWithLabels(seeds, cv2.DIST_L2, 5, labelType=cv2.DIST_LABEL_PIXEL)
    table = np.zeros(labels.max() + 1, np.float32)
    at = seeds == 0
    table[labels[at]] = radius_at[at]
    radius = table[labels]
    inside = np.sqrt(np.maximum(radius**2 - (distance / SUPER) ** 2, 0))
    return cv2.resize(2 * inside, (shape[1], shape[0]), interpolation=cv2.INTER_AREA)


def _noise_field(rng, shape, sigma):
    """Slow random field of spread one."""
    small = max(1.0, sigma / 3.0)
    h, w = int(shape[0] / small) + 9, int(shape[1] / small) + 9
    field = cv2.GaussianBlur(rng.normal(0, 1, (h, w)).astype(np.float32), (0, 0), sigma / small)
    field = cv2.resize(field, (shape[1] + 16, shape[0] + 16), interpolation=cv2.INTER_CUBIC)[8:-8, 8:-8]
    return (field - field.mean()) / (field.std() + 1e-6)


def vessel_tree(rng, shape, where):
    """Thickness of vessels (list of groups that add up)."""
    size = min(shape)
    style = dict(
        bend=rng.uniform(0.1, 0.6),
        wave=rng.choice([0.0, rng.uniform(0.2, 1.2)]),
        taper=rng.uniform(0.35, 0.9),
        children=rng.uniform(0.8, 3.2),
    )
    radius = np.exp(rng.uniform(np.log(1.6), np.log(9.0)))
    groups = []
    for _ in range(rng.integers(1, 4)):
        branches = []
        angle = np.arctan2(*(np.array(shape[::-1]) * rng.uniform(0.3, 0.7, 2) - where)[::-1]) + rng.normal(0, 0.7)
        _branch(rng, branches, where, angle, radius * rng.uniform(0.6, 1.0), size * rng.uniform(0.4, 1.3), style,
                int(rng.integers(2, 5)))
        groups.append(branches)
    return [_thickness(shape, branches) for branches in groups]


def _edge_course(rng, shape):
    """A point on the image's edge and the direction inwards."""
    h, w = shape
    side = rng.integers(4)
    t = rng.uniform(0.05, 0.95)
    point = [(t * w, -3.0), (w + 3.0, t * h), (t * w, h + 3.0), (-3.0, t * h)][side]
    return np.array(point), [np.pi / 2, np.pi, -np.pi / 2, 0.0][side] + rng.normal(0, 0.4)


def _smooth_course(rng, shape, until=None):
    start, angle = _edge_course(rng, shape)
    length = min(shape) * rng.uniform(0.4, 1.6)
    if until is None:
        count = int(length / 2)
        bends = np.interp(np.linspace(0, 1, count), np.linspace(0, 1, 4), rng.normal(0, rng.choice([0.002, 0.012, 0.03]), 4))
        angles = angle + np.cumsum(bends * 2)
        return start + np.cumsum(2 * np.stack([np.cos(angles), np.sin(angles)], 1), 0)
    reach = np.linalg.norm(until - start)
    control = start + np.array([np.cos(angle), np.sin(angle)]) * reach * rng.uniform(0.3, 1.3)
    second = until + rng.normal(0, 0.25, 2) * reach
    t = np.linspace(0, 1, max(8, int(reach / 2)))[:, None]
    return (1 - t) ** 3 * start + 3 * t * (1 - t) ** 2 * control + 3 * t**2 * (1 - t) * second + t**3 * until


def _tube(shape, course, radius):
    return _thickness(shape, [(course, np.full(len(course), radius))])


def catheter(rng, shape, until=None):
    """Attenuating thickness of a catheter, wire or lead, and where it is."""
    course = _smooth_course(rng, shape, until)
    kind = rng.random()
    if kind < 0.3:  # wire or lead
        solid = _tube(shape, course, rng.uniform(0.5, 1.5))
        return solid * rng.uniform(0.8, 3.0), solid > 0.3
    outer = rng.uniform(1.5, 4.5)
    solid = _tube(shape, course, outer)
    if kind < 0.7:  # hollow: both walls are seen
        hollow = solid - rng.uniform(0.7, 1.0) * _tube(shape, course, outer * rng.uniform(0.55, 0.85))
        return np.maximum(hollow, 0) * rng.uniform(0.5, 1.5), solid > 0.3
    return solid * rng.uniform(0.3, 1.3), solid > 0.3


def _blobs(rng, shape):
    """Clips, coils, sternal wires, markers: dark, no vessel. Returns thickness and whether to call them device."""
    dark = np.zeros(shape, np.float32)
    device = np.zeros(shape, bool)
    h, w = shape
    for _ in range(rng.integers(0, 4)):
        kind = rng.integers(4)
        centre = rng.uniform(0, 1, 2) * (w, h)
        canvas = np.zeros(shape, np.float32)
        if kind == 0:  # clip
            d = rng.normal(0, 1, 2)
            d *= rng.uniform(2, 7) / np.linalg.norm(d)
            cv2.line(canvas, tuple(int(v) for v in centre - d), tuple(int(v) for v in centre + d), 1.0,
                     int(rng.integers(1, 4)), cv2.LINE_AA)
        elif kind == 1:  # coil
            points, _ = _walk(rng, centre, rng.uniform(0, 6.3), rng.uniform(60, 260), 2.5, 1.5)
            points = centre + (points - points.mean(0)) * 0.6
            canvas = np.minimum(_tube(shape, points, rng.uniform(0.7, 1.6)), 3)
        elif kind == 2:  # sternal wire: a loop with a twist
            radius = rng.uniform(6, 22)
            t = np.linspace(0, 2 * np.pi, 60)
            squash = rng.uniform(0.2, 1.0)
            turn = rng.uniform(0, 3.2)
            loop = np.stack([np.cos(t) * radius, np.sin(t) * radius * squash], 1) @ np.array(
                [[np.cos(turn), np.sin(turn)], [-np.sin(turn), np.cos(turn)]])
            canvas = _tube(shape, centre + loop, rng.uniform(0.7, 1.5))
        else:  # ring or ball marker
            cv2.circle(canvas, tuple(int(v) for v in centre), int(rng.integers(2, 9)), 1.0,
                       int(rng.choice([-1, 1, 2])), cv2.LINE_AA)
        device |= canvas > 0.3
        dark += canvas * rng.uniform(1, 5)
    return dark, device


def _clutter(rng, shape, strength):
    """Bones, organs and lungs: slow fields, soft edges, bands and fine threads (faint, no vessels)."""
    h, w = shape
    out = np.zeros(shape, np.float32)
    for sigma, gain in ((90, 1.0), (40, 0.5), (18, 0.25), (8, 0.10), (4, 0.06)):
        out += gain * rng.uniform(0.2, 1.2) * _noise_field(rng, shape, sigma)
    y, x = np.mgrid[0:h, 0:w].astype(np.float32)
    for _ in range(rng.integers(0, 4)):  # edges of organs: heart, diaphragm, liver
        centre = rng.uniform(-0.6, 1.6, 2) * (w, h)
        radius = rng.uniform(0.3, 1.4) * w
        stretch = rng.uniform(0.6, 1.6)
        inside = radius - np.hypot(x - centre[0], (y - centre[1]) * stretch) + 6 * _noise_field(rng, shape, 30)
        out += rng.uniform(0.3, 2.0) * rng.choice([-1, 1, 1]) / (1 + np.exp(-np.clip(inside / rng.uniform(0.8, 6), -30, 30)))
    if rng.random() < 0.55:  # ribs
        tilt, spacing, width = rng.uniform(-0.6, 0.6), rng.uniform(35, 90), rng.uniform(0.15, 0.45)
        bend = rng.uniform(-1, 1) * 0.002
        phase = ((y + tilt * x + bend * (x - w / 2) ** 2 + 3 * _noise_field(rng, shape, 40)) / spacing + rng.random()) % 1.0
        band = 1 / (1 + np.exp(-np.clip((width / 2 - np.abs(phase - 0.5)) * spacing / rng.uniform(0.7, 3), -30, 30)))
        rim = np.exp(-0.5 * ((np.abs(phase - 0.5) - width / 2) * spacing / rng.uniform(1, 2.5)) ** 2)
        out += rng.uniform(0.1, 0.6) * band + rng.uniform(0, 0.35) * rim
    if rng.random() < 0.3:  # spine
        axis = rng.uniform(0, w) + rng.uniform(-0.3, 0.3) * y
        column = 1 / (1 + np.exp(-np.clip((rng.uniform(20, 45) - np.abs(x - axis)) / rng.uniform(1, 5), -30, 30)))
        out += column * (rng.uniform(0.3, 1.0) + rng.uniform(0, 0.3) * (np.cos(2 * np.pi * y / rng.uniform(35, 70)) > rng.uniform(-0.6, 0.8)))
    out *= strength
    if rng.random() < 0.6:  # fine threads: lung vessels, tiny branches nobody would draw
        branches = []
        for _ in range(rng.integers(5, 60)):
            p, _ = _walk(rng, rng.uniform(0, 1, 2) * (w, h), rng.uniform(0, 6.3), rng.uniform(8, 70), 0.5, 0.5)
            branches.append((p, np.full(len(p), rng.uniform(0.4, 1.1))))
        out += _thickness(shape, branches) * rng.uniform(0.01, 0.10) * rng.choice([1, 1, -1])
    return out


def _field(rng, shape):
    """Exposed share 0…1, with soft or sharp edge, and whether there is a border at all."""
    h, w = shape
    if rng.random() < 0.3:
        return np.ones(shape, np.float32)
    y, x = np.mgrid[0:h, 0:w].astype(np.float32)
    centre = np.array([w, h]) * rng.uniform(0.4, 0.6, 2)
    turn = rng.uniform(-0.6, 0.6) if rng.random() < 0.4 else 0.0
    u = (x - centre[0]) * np.cos(turn) + (y - centre[1]) * np.sin(turn)
    v = -(x - centre[0]) * np.sin(turn) + (y - centre[1]) * np.cos(turn)
    inside = np.full(shape, 1e6, np.float32)
    if rng.random() < 0.65:
        inside = np.minimum(inside, rng.uniform(0.45, 0.68) * min(w, h) - np.hypot(u, v))
    if rng.random() < 0.5:
        inside = np.minimum(inside, rng.uniform(0.35, 0.55) * w - np.abs(u))
        inside = np.minimum(inside, rng.uniform(0.35, 0.55) * h - np.abs(v))
    if rng.random() < 0.2:
        inside = np.minimum(inside, rng.uniform(0.45, 0.62) * (w + h) * 0.7 - np.abs(u) - np.abs(v))
    soft = rng.choice([0.3, 1.0, 4.0, rng.uniform(4, 12)])
    return (1 / (1 + np.exp(-np.clip(inside / soft, -30, 30)))).astype(np.float32)


def _text(rng, frame):
    low, high = float(frame.min()), float(frame.max())
    for _ in range(rng.integers(1, 6)):
        text = "".join(rng.choice(list("ABCDEFRLAOCRAU0123456789 :/.-"), rng.integers(3, 16)))
        place = (int(rng.uniform(0, 0.8) * frame.shape[1]), int(rng.uniform(0.04, 0.99) * frame.shape[0]))
        cv2.putText(frame, text, place, int(rng.choice([0, 1, 2])), rng.uniform(0.3, 0.6),
                    float(rng.choice([low, high, high])), 1, int(rng.choice([cv2.LINE_8, cv2.LINE_AA])))


def simulated_frame(seed, size=320):
    """(frame 0…255 as uint8 with dark vessels, classes as uint8) of the seed."""
    rng = np.random.default_rng(seed)
    shape = (size, size)
    root = rng.uniform(0.1, 0.9, 2) * size if rng.random() < 0.6 else _edge_course(rng, shape)[0]
    is_subtracted = rng.random() < 0.4
    groups = vessel_tree(rng, shape, root) if rng.random() < 0.95 else []
    if rng.random() < 0.25 and groups:
        groups += vessel_tree(rng, shape, rng.uniform(0, 1, 2) * size)
    per_px = np.exp(rng.uniform(np.log(0.02), np.log(0.14)))
    widest = max([g.max() for g in groups] + [1.0])
    per_px = min(per_px, rng.uniform(0.5, 1.3) / widest)  # the widest vessel is no blacker than that
    filling = [1.0] + [rng.choice([1.0, rng.uniform(0.35, 1.0)]) for _ in groups[1:]]
    vessels = sum((f * g for f, g in zip(filling, groups)), np.zeros(shape, np.float32)) * per_px
    if rng.random() < 0.3:  # contrast thins out on the way
        vessels *= np.clip(1 + 0.5 * _noise_field(rng, shape, 60), 0.15, 1)

    device_at = np.zeros(shape, bool)
    devices = np.zeros(shape, np.float32)
    for k in range(rng.choice([0, 1, 1, 2, 3])):
        until = root + rng.normal(0, 3, 2) if k == 0 and rng.random() < 0.75 else None
        dark, at = catheter(rng, shape, until)
        devices += dark * per_px * rng.uniform(0.5, 1.6)
        device_at |= at
    if rng.random() < 0.35:
        dark, at = _blobs(rng, shape)
        devices += dark * rng.uniform(0.03, 0.15)
        device_at |= at

    strength = rng.uniform(0.0, 0.06) if is_subtracted else rng.uniform(0.05, 0.45)
    clutter = _clutter(rng, shape, strength)
    if is_subtracted:
        devices *= rng.choice([0.0, rng.uniform(0.05, 0.6), 1.0])
        if rng.random() < 0.5:  # edges that moved against the mask image
            moved = _clutter(rng, shape, rng.uniform(0.05, 0.3))
            clutter = clutter + moved - np.roll(moved, (int(rng.integers(-1, 2)), int(rng.integers(-2, 3))), (0, 1))
    if rng.random() < 0.25:  # veil of contrast in muscle, a chamber or the aorta
        blob = np.clip(_noise_field(rng, shape, rng.uniform(15, 50)) - 0.8, 0, 1.5)
        clutter += blob * rng.uniform(0.02, 0.2)

    absorbed = vessels + devices + clutter
    exposed = _field(rng, shape)
    signal = np.exp(-absorbed) if not is_subtracted else 1.6 - absorbed
    noise = rng.uniform(0.005, 0.05)
    signal = cv2.GaussianBlur(signal.astype(np.float32), (0, 0), rng.uniform(0.4, 1.3))
    grain = rng.normal(0, 1, shape).astype(np.float32)
    if rng.random() < 0.6:
        grain = cv2.GaussianBlur(grain, (0, 0), rng.uniform(0.4, 1.2))
        grain /= grain.std()
    frame = signal + noise * grain * np.sqrt(np.maximum(signal, 0.1))
    outside = rng.choice([frame.min() - 0.2, frame.min(), frame.max(), float(np.median(frame))], p=[0.6, 0.2, 0.1, 0.1])
    frame = exposed * frame + (1 - exposed) * (outside + 0.2 * noise * grain * (rng.random() < 0.5))
    low, high = np.percentile(frame, [rng.uniform(0, 1), rng.uniform(99, 100)])
    frame = np.clip((frame - low) / (high - low + 1e-6), 0, 1) ** np.exp(rng.normal(0, 0.35))
    frame = 255 * frame
    if rng.random() < 0.25:
        _text(rng, frame)
    if rng.random() < 0.15:
        levels = rng.integers(16, 64)
        frame = np.round(frame / 255 * levels) * 255 / levels
    frame = np.clip(frame, 0, 255).astype(np.uint8)
    if rng.random() < 0.25:
        frame = cv2.imdecode(cv2.imencode(".jpg", frame, [cv2.IMWRITE_JPEG_QUALITY, int(rng.integers(30, 90))])[1], 0)

    classes = np.full(shape, BACKGROUND, np.uint8)
    light = np.clip(signal, 0.02, 1.0) if not is_subtracted else np.ones(shape, np.float32)
    # What is seen against the noise (of wide vessels more) and against the grey values of the whole frame.
    visible = 0.9 * noise * np.sqrt(light) + 0.02 * (high - low)
    contrast = cv2.GaussianBlur(vessels, (0, 0), 0.6) * light
    width = cv2.GaussianBlur(sum(groups), (0, 0), 0.6) if groups else np.zeros(shape, np.float32)
    if groups:
        classes[sum(groups) > 0.2] = UNSURE
        classes[(contrast * np.sqrt(np.maximum(width, 1) / 2) > visible) & (vessels > 0.35 * per_px)] = VESSEL
    if devices.max() > 1e-4:
        strong = devices * light > 0.6 * visible
        classes[device_at & strong & (devices > 0.6 * vessels)] = DEVICE
        classes[device_at & ~strong & (classes != VESSEL)] = UNSURE
    classes[exposed < 0.5] = BACKGROUND
    return frame, classes
