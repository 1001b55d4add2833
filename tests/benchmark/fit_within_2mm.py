#!/usr/bin/env python3
"""Learns the probability that an overlay lies within 2 mm from what trust_table --world made-up --dump wrote.

Usage: fit_within_2mm.py LEARN.csv [CHECK.csv]
Logistic regression by Newton's method, every sign and its square in standard units, L2 penalty chosen by leaving
whole trees out ten times; prints the table of core/registration/judging/within_2mm.cpp. CHECK.csv, other numbers of the
same world, is only scored.
"""
import csv
import sys

import numpy as np

FIRST_SIGN = 5


def read(path):
    with open(path, newline="") as file:
        rows = list(csv.reader(file))
    names = rows[0][FIRST_SIGN:-1]
    trees = np.array([row[0] for row in rows[1:]])
    signs = np.array([[float(cell) for cell in row[FIRST_SIGN:-1]] for row in rows[1:]])
    is_within = np.array([row[2] == "0" and float(row[3]) < 2.0 for row in rows[1:]], dtype=float)
    trusted = np.array([row[4] == "1" for row in rows[1:]])
    return names, trees, signs, is_within, trusted


def terms(signs, mean, scale):
    units = np.clip((signs - mean) / scale, -3.0, 3.0)
    return np.hstack([np.ones((len(units), 1)), units, units**2])


def fitted(x, y, penalty):
    weights = np.zeros(x.shape[1])
    keep = np.full(x.shape[1], penalty)
    keep[0] = 1e-6
    for _ in range(50):
        p = 1.0 / (1.0 + np.exp(-x @ weights))
        gradient = x.T @ (p - y) + keep * weights
        hessian = (x * (p * (1.0 - p))[:, None]).T @ x + np.diag(keep)
        step = np.linalg.solve(hessian, gradient)
        weights -= step
        if np.abs(step).max() < 1e-8:
            break
    return weights


def probability(x, weights):
    return 1.0 / (1.0 + np.exp(-x @ weights))


def log_loss(p, y):
    p = np.clip(p, 1e-6, 1.0 - 1e-6)
    return -np.mean(y * np.log(p) + (1.0 - y) * np.log(1.0 - p))


def left_out(trees, x, y, penalty):
    fold = {tree: number % 10 for number, tree in enumerate(sorted(set(trees)))}
    folds = np.array([fold[tree] for tree in trees])
    p = np.zeros(len(y))
    for number in range(10):
        p[folds == number] = probability(x[folds == number], fitted(x[folds != number], y[folds != number], penalty))
    return p


def area_under_curve(p, y):
    order = np.argsort(p, kind="stable")
    rank = np.empty(len(p))
    rank[order] = np.arange(1, len(p) + 1)
    good = y.sum()
    return (rank[y == 1].sum() - good * (good + 1) / 2) / (good * (len(y) - good))


def say(title, p, y, trusted):
    print(f"// {title}: {len(y)} runs, {y.mean():.3f} within 2 mm; log loss {log_loss(p, y):.4f}, "
          f"Brier {np.mean((p - y) ** 2):.4f}, area under the curve {area_under_curve(p, y):.4f}")
    for low, high in [(0, .05), (.05, .2), (.2, .4), (.4, .6), (.6, .8), (.8, .9), (.9, .97), (.97, 1.01)]:
        inside = (p >= low) & (p < high)
        if inside.any():
            print(f"//   {low:.2f}-{high:.2f}: {inside.sum():5d} runs, stated {p[inside].mean():.3f}, "
                  f"true {y[inside].mean():.3f}")
    print(f"//   rules: flagged of the wrong {np.mean(~trusted[y == 0]):.3f}, of the right {np.mean(~trusted[y == 1]):.3f}")
    for bound in (.5, .6, .7, .8, .9):
        print(f"//   below {bound}: of the wrong {np.mean(p[y == 0] < bound):.3f}, of the right {np.mean(p[y == 1] < bound):.3f};"
              f" with the rules {np.mean((p < bound)[y == 0] | ~trusted[y == 0]):.3f},"
              f" {np.mean((p < bound)[y == 1] | ~trusted[y == 1]):.3f}")


def main():
    names, trees, signs, y, trusted = read(sys.argv[1])
    mean, scale = signs.mean(axis=0), np.maximum(signs.std(axis=0), 1e-3)
    x = terms(signs, mean, scale)
    penalty = min((0.3, 1.0, 3.0, 10.0, 30.0), key=lambda candidate: log_loss(left_out(trees, x, y, candidate), y))
    print(f"// penalty {penalty}")
    say("trees left out", left_out(trees, x, y, penalty), y, trusted)
    weights = fitted(x, y, penalty)
    if len(sys.argv) > 2:
        _, _, other, truth, others_trusted = read(sys.argv[2])
        say("check", probability(terms(other, mean, scale), weights), truth, others_trusted)
    print(f"constexpr double constantTerm = {weights[0]:.4f};")
    print("constexpr std::array<Weight, signCount> weights{{")
    for k, name in enumerate(names):
        print(f"    {{{mean[k]:.4f}, {scale[k]:.4f}, {weights[1 + k]:.4f}, {weights[1 + len(names) + k]:.4f}}},   // {name}")
    print("}};")


if __name__ == "__main__":
    main()
