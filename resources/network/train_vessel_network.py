#!/usr/bin/env python3
"""Trains the vessel network of core/tracing/angiogram/evidence; see README.md beside it.

  train_vessel_network.py simulate WORK [--count 900]     draws the simulated frames
  train_vessel_network.py pretrain WORK [--steps 2000]    learns from them alone
  train_vessel_network.py tune WORK REAL --fold K         goes on with the real pairs outside fold K (0: with all)
  train_vessel_network.py export WORK --fold K FILE.onnx

Every step is seeded; with one thread it gives the same weights again.
"""

import argparse
import copy
import math
import os
import time

import cv2
import numpy as np
import torch
import torch.nn as nn
import torch.nn.functional as F

from simulated_angiograms import DEVICE, UNSURE, VESSEL, simulated_frame

CHANNELS = (8, 24, 48, 64, 64)
CROP, BATCH, REAL_IN_BATCH = 192, 4, 3
LOCAL_SIGMA = 16.0
THICK = cv2.getStructuringElement(cv2.MORPH_ELLIPSE, (5, 5))
REAL_COUNT = 40
# Frames of one run (2 3, 5 6, 9 12, 14 15) stay together.
FOLDS = {
    1: [1, 2, 3, 4, 5, 6, 7, 8, 9, 12],
    2: [10, 11, 13, 14, 15, 16, 17, 18, 19, 20],
    3: list(range(21, 31)),
    4: list(range(31, 41)),
}


def network_input(frame):
    """Two channels of a frame with dark vessels: grey against the surroundings, and within the whole frame."""
    frame = frame.astype(np.float32)
    blur = lambda image: cv2.GaussianBlur(image, (0, 0), LOCAL_SIGMA, borderType=cv2.BORDER_REPLICATE)
    difference = frame - blur(frame)
    spread = np.sqrt(np.maximum(blur(difference * difference), 0))
    local = difference / (spread + 0.25 * spread.mean() + 1e-6)
    low, high = np.percentile(frame, [2, 98])
    whole = (frame - low) / (high - low + 1e-6) - 0.5
    return np.stack([np.clip(local, -4, 4), np.clip(whole, -1, 1)]).astype(np.float32)


class Pair(nn.Sequential):
    def __init__(self, i, o):
        super().__init__(
            nn.Conv2d(i, o, 3, padding=1, bias=False), nn.BatchNorm2d(o), nn.ReLU(True),
            nn.Conv2d(o, o, 3, padding=1, bias=False), nn.BatchNorm2d(o), nn.ReLU(True))


class VesselNetwork(nn.Module):
    """A U-Net; gives logits of background, vessel and device."""

    def __init__(self, channels=CHANNELS):
        super().__init__()
        n = len(channels) - 1
        self.down = nn.ModuleList([Pair(2 if k == 0 else channels[k - 1], channels[k]) for k in range(n + 1)])
        self.narrow = nn.ModuleList([nn.Conv2d(channels[k + 1], channels[k], 1) for k in range(n)])
        self.up = nn.ModuleList([Pair(2 * channels[k], channels[k]) for k in range(n)])
        self.out = nn.Conv2d(channels[0], 3, 1)

    def forward(self, x):
        seen = []
        for k, block in enumerate(self.down):
            x = block(F.max_pool2d(x, 2) if k else x)
            seen.append(x)
        for k in reversed(range(len(self.up))):
            x = F.interpolate(self.narrow[k](x), scale_factor=2.0, mode="nearest")
            x = self.up[k](torch.cat([seen[k], x], 1))
        return self.out(x)


def warped(rng, frame, classes, scales):
    """A crop of the frame, turned, mirrored, stretched and bent."""
    turn, scale = rng.uniform(0, 2 * np.pi), np.exp(rng.uniform(np.log(scales[0]), np.log(scales[1])))
    stretch = np.exp(rng.normal(0, 0.08))
    matrix = np.array([[np.cos(turn), -np.sin(turn)], [np.sin(turn), np.cos(turn)]]) @ np.diag([stretch, 1 / stretch])
    if rng.random() < 0.5:
        matrix = matrix @ np.diag([-1.0, 1.0])
    matrix /= scale
    y, x = np.mgrid[0:CROP, 0:CROP].astype(np.float32) - (CROP - 1) / 2
    for axis in (x, y):
        if rng.random() < 0.6:
            small = rng.normal(0, 1, (8, 8)).astype(np.float32)
            axis += rng.uniform(0, 5) * cv2.resize(small, (CROP, CROP), interpolation=cv2.INTER_CUBIC)
    h, w = frame.shape
    reach = 0.35 * CROP / scale
    centre = [rng.uniform(min(reach, w / 2), max(w - reach, w / 2)), rng.uniform(min(reach, h / 2), max(h - reach, h / 2))]
    if rng.random() < 0.7 and (classes == VESSEL).any():  # most crops show a vessel
        ys, xs = np.nonzero(classes == VESSEL)
        i = rng.integers(len(ys))
        centre = np.array([xs[i], ys[i]]) + rng.normal(0, 0.2 * CROP / scale, 2)
    at_x = (matrix[0, 0] * x + matrix[0, 1] * y + centre[0]).astype(np.float32)
    at_y = (matrix[1, 0] * x + matrix[1, 1] * y + centre[1]).astype(np.float32)
    border = rng.choice([cv2.BORDER_REFLECT_101, cv2.BORDER_REPLICATE])
    crop = cv2.remap(frame.astype(np.float32), at_x, at_y, cv2.INTER_LINEAR, borderMode=int(border))
    labels = cv2.remap(classes, at_x, at_y, cv2.INTER_NEAREST, borderMode=cv2.BORDER_CONSTANT, borderValue=UNSURE)
    if set(np.unique(classes)) <= {0, VESSEL}:  # smoother edges for masks
        soft = cv2.remap((classes == VESSEL).astype(np.float32), at_x, at_y, cv2.INTER_LINEAR)
        labels = np.where(labels == UNSURE, UNSURE, (soft > 0.5).astype(np.uint8) * VESSEL).astype(np.uint8)
    return crop, labels


def altered(rng, frame):
    """Other detectors, exports and doses."""
    frame = frame / 255.0
    frame = np.clip(frame, 0, None) ** np.exp(rng.normal(0, 0.3))
    if rng.random() < 0.5:
        slow = cv2.resize(rng.normal(0, 1, (4, 4)).astype(np.float32), (CROP, CROP), interpolation=cv2.INTER_CUBIC)
        frame = frame * (1 + rng.uniform(0, 0.25) * slow)
    if rng.random() < 0.3:
        frame = cv2.GaussianBlur(frame, (0, 0), rng.uniform(0.4, 1.4))
    if rng.random() < 0.15:  # doubled pixels
        small = cv2.resize(frame, (CROP // 2, CROP // 2), interpolation=cv2.INTER_AREA)
        frame = cv2.resize(small, (CROP, CROP), interpolation=int(rng.choice([cv2.INTER_NEAREST, cv2.INTER_LINEAR])))
    if rng.random() < 0.5:
        grain = rng.normal(0, 1, frame.shape).astype(np.float32)
        if rng.random() < 0.5:
            grain = 1.5 * cv2.GaussianBlur(grain, (0, 0), 0.7)
        frame = frame + rng.uniform(0, 0.05) * grain
    if rng.random() < 0.1:
        levels = rng.integers(12, 60)
        frame = np.round(frame * levels) / levels
    if rng.random() < 0.1:
        bytes_ = cv2.imencode(".jpg", np.clip(255 * frame, 0, 255).astype(np.uint8),
                              [cv2.IMWRITE_JPEG_QUALITY, int(rng.integers(25, 90))])[1]
        frame = cv2.imdecode(bytes_, 0) / 255.0
    return frame.astype(np.float32)


def sample(rng, frames, scales):
    frame, classes = frames[rng.integers(len(frames))]
    crop, labels = warped(rng, frame, classes, scales)
    vessel = (labels == VESSEL).astype(np.uint8)
    thin = vessel & ~cv2.morphologyEx(vessel, cv2.MORPH_OPEN, THICK)  # easily lost, and half of all length
    return network_input(altered(rng, crop)), labels, thin


def loss_of(logits, labels, thin, real_count):
    """Cross entropy and Dice. Real pairs (the first of the batch) know vessel and the rest only."""
    log_p = F.log_softmax(logits, 1)
    p = log_p.exp()
    sure = (labels != UNSURE).float()
    vessel = (labels == VESSEL).float()
    device = (labels == DEVICE).float()
    rest = sure - vessel - device
    log_not_vessel = torch.logsumexp(log_p[:, [0, 2]], 1)
    is_real = torch.zeros(len(labels), 1, 1)
    is_real[:real_count] = 1
    # Simulated vessels are all labelled, of real ones those that somebody found worth drawing.
    weight = is_real + (1 - is_real) * (1.5 + thin)
    nll = -weight * vessel * log_p[:, VESSEL] - 2.0 * device * log_p[:, DEVICE]
    nll = nll - rest * (is_real * log_not_vessel + (1 - is_real) * log_p[:, 0])
    overlap = lambda a, b: 1 - (2 * (a * b).sum() + 50) / (a.sum() + b.sum() + 50)
    total = nll.sum() / sure.sum() + overlap(p[:, VESSEL] * sure, vessel)
    if real_count < len(labels):
        total = total + 0.5 * overlap((p[:, DEVICE] * sure)[real_count:], device[real_count:])
    return total


def train(model, draw, steps, rate, name, work, check=None, until=None):
    """`draw()` gives inputs, labels, what of them is thin, and how many are real. Stores the running mean of the
    weights; ends at step `until` of the plan for `steps`."""
    optimizer = torch.optim.AdamW(model.parameters(), lr=rate, weight_decay=1e-3)
    schedule = torch.optim.lr_scheduler.OneCycleLR(optimizer, rate, steps, pct_start=0.15, final_div_factor=200)
    mean = copy.deepcopy(model)
    running, begin = None, time.time()
    for step in range(1, (until or steps) + 1):
        model.train()
        x, y, thin, real_count = draw()
        loss = loss_of(model(x), y, thin, real_count)
        optimizer.zero_grad()
        loss.backward()
        nn.utils.clip_grad_norm_(model.parameters(), 2.0)
        optimizer.step()
        schedule.step()
        keep = min(0.99, step / (step + 10.0))
        with torch.no_grad():
            for a, b in zip(mean.state_dict().values(), model.state_dict().values()):
                a.copy_(keep * a + (1 - keep) * b if a.dtype.is_floating_point else b)
        running = loss.item() if running is None else 0.98 * running + 0.02 * loss.item()
        if step % 25 == 0:
            print(f"{name} {step:5d} loss {running:.4f} {(time.time() - begin) / step:.3f} s", flush=True)
        if step % 200 == 0 or step == (until or steps):
            torch.save(mean.state_dict(), f"{work}/{name}.pt")
            if check:
                print(f"{name} {step:5d} {check(mean)}", flush=True)


def probabilities(model, frame):
    """Of a whole frame, padded to whole cells of the coarsest level."""
    model.eval()
    x = torch.from_numpy(network_input(frame))[None]
    cell = 2 ** (len(CHANNELS) - 1)
    h, w = frame.shape
    x = F.pad(x, (0, -w % cell, 0, -h % cell), mode="replicate")
    with torch.no_grad():
        return torch.softmax(model(x), 1)[0, :, :h, :w].numpy()


def dice_of(model, pairs):
    dices = []
    for frame, classes in pairs:
        p, t = probabilities(model, frame)[VESSEL] > 0.5, classes == VESSEL
        dices.append(2 * (p & t).sum() / (p.sum() + t.sum() + 1e-9))
    return f"Dice mean {np.mean(dices):.4f} lowest {np.min(dices):.4f}"


def read_real(folder, numbers):
    return [(cv2.imread(f"{folder}/{n}.png", 0), (cv2.imread(f"{folder}/{n}_gt.png", 0) > 127).astype(np.uint8) * VESSEL)
            for n in numbers]


def read_simulated(work):
    frames = []
    for name in sorted(f for f in os.listdir(work) if f.startswith("simulated")):
        data = np.load(f"{work}/{name}")
        frames += list(zip(data["frames"], data["classes"]))
    return frames


def batch_of(samples):
    return (torch.from_numpy(np.stack([s[0] for s in samples])),
            torch.from_numpy(np.stack([s[1] for s in samples]).astype(np.int64)),
            torch.from_numpy(np.stack([s[2] for s in samples]).astype(np.float32)))


def simulate(args):
    for first in range(args.first, args.first + args.count, 100):
        drawn = [simulated_frame(seed) for seed in range(first, min(first + 100, args.first + args.count))]
        np.savez_compressed(f"{args.work}/part{first:06d}.npz", frames=np.stack([d[0] for d in drawn]),
                            classes=np.stack([d[1] for d in drawn]))
        os.rename(f"{args.work}/part{first:06d}.npz", f"{args.work}/simulated{first:06d}.npz")  # whole files only


def pretrain(args):
    torch.manual_seed(1)
    rng = np.random.default_rng(1)
    frames = read_simulated(args.work)
    held, frames = frames[:20], frames[20:]
    print(len(frames), "frames", sum(p.numel() for p in VesselNetwork().parameters()), "weights", flush=True)
    draw = lambda: (*batch_of([sample(rng, frames, (0.55, 1.5)) for _ in range(BATCH)]), 0)
    train(VesselNetwork(), draw, args.steps, 4e-3, "pretrained", args.work, lambda m: dice_of(m, held),
          args.until)


def tune(args):
    seed = 10 + args.fold + (0 if args.start == "pretrained" else 100)
    torch.manual_seed(seed)
    rng = np.random.default_rng(seed)
    unseen = FOLDS.get(args.fold, [])
    real = read_real(args.real, [n for n in range(1, REAL_COUNT + 1) if n not in unseen])
    held = read_real(args.real, unseen)
    simulated = read_simulated(args.work)
    model = VesselNetwork()
    model.load_state_dict(torch.load(f"{args.work}/pretrained.pt"))
    def draw():
        samples = [sample(rng, real, (0.7, 1.5)) for _ in range(REAL_IN_BATCH)]
        samples += [sample(rng, simulated, (0.55, 1.5)) for _ in range(BATCH - REAL_IN_BATCH)]
        return (*batch_of(samples), REAL_IN_BATCH)

    # What the held frames show during training is printed, and chooses nothing.
    train(model, draw, args.steps, args.rate, args.name.format(fold=args.fold), args.work,
          (lambda m: dice_of(m, held)) if held else None)


def fused(model):
    """With the normalisation of each batch taken into the weights."""
    model = copy.deepcopy(model).eval()
    for pair in [*model.down, *model.up]:
        for i in (0, 3):
            pair[i] = nn.utils.fuse_conv_bn_eval(pair[i], pair[i + 1])
            pair[i + 1] = nn.Identity()
    return model


class Exported(nn.Module):
    def __init__(self, model):
        super().__init__()
        self.model = model

    def forward(self, x):
        return torch.softmax(self.model(x), 1)


def export(args):
    model = VesselNetwork()
    model.load_state_dict(torch.load(f"{args.work}/{args.name.format(fold=args.fold)}.pt"))
    model = fused(model)
    for weights in model.parameters():  # 16 bits are enough, and pack to half the size
        weights.data = weights.data.half().float()
    torch.onnx.export(Exported(model), torch.zeros(1, 2, 160, 160), args.file, opset_version=11,
                      input_names=["frame"], output_names=["classes"])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("step", choices=["simulate", "pretrain", "tune", "export"])
    parser.add_argument("work")
    parser.add_argument("real", nargs="?", help="folder of N.png and N_gt.png; with export: the file to write")
    parser.add_argument("--count", type=int, default=900)
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--steps", type=int, default=2000)
    parser.add_argument("--until", type=int)
    parser.add_argument("--start", default="pretrained", help="weights that tuning goes on from")
    parser.add_argument("--name", default="fold{fold}", help="and their name in the end")
    parser.add_argument("--rate", type=float, default=2e-3)
    parser.add_argument("--fold", type=int, default=0)
    parser.add_argument("--threads", type=int, default=1)
    args = parser.parse_args()
    args.file = args.real
    torch.set_num_threads(args.threads)
    cv2.setNumThreads(1)
    {"simulate": simulate, "pretrain": pretrain, "tune": tune, "export": export}[args.step](args)


if __name__ == "__main__":
    main()
