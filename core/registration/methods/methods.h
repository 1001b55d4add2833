#pragma once

#include "core/registration/methods/method.h"

// Solvers of all methods, each in its own file; method_table.cpp lists their display names.
namespace angiopose::core {

/// Default method (ALGORITHMS §6): coarse search → robust refinement of the best hypotheses → full refinement of the
/// best pose, all about the tree's centroid.
MethodSolver solveAngioPose;

/// DynaWeightPnP (ALGORITHMS §3.2): a rotation about the source, then alternation between auxiliary points with fixed
/// matches and all points with updated matches.
MethodSolver solveDynaWeight;

/// DynaWeightPnP* (ALGORITHMS §3.1): kernel PnP with all points from the initial pose.
MethodSolver solveIterativePnp;

/// Gradient ascent, coarse to fine, on the mean kernel between projected tree and target (ALGORITHMS §3.3) or on the
/// ridge intensity at each vessel's own width (§3.4, option `nicpImage`). Source: Aylward et al. 2003, as described by
/// Song and Ghaffari.
MethodSolver solveNicp;

/// Runs solveNicp inside the alternating search (§3.5).
MethodSolver solveNicpAlternating;

/// Minimizes the Huber loss of the distances to the nearest traced vessel by damped steps with updated matches, or the
/// squared distances by L-BFGS; optional affine stage (ALGORITHMS §3.6). Source: Rivest-Hénault et al. 2012.
MethodSolver solveDtIcp;

/// Baseline for other methods, built from library components: repeats nearest-neighbor matching (nanoflann) and
/// OpenCV's SQPNP (Terzakis, Lourakis 2020) until the pairs no longer change (ALGORITHMS §3.14). Fast and accurate if
/// the whole tree is in the image and the initial pose is close.
MethodSolver solveAssembledIcp;

/// Finds image edges along the normals of the vessel walls, selects a pose by RANSAC with a gradient-matching score,
/// and repeats this with a shorter search range (ALGORITHMS §3.8). Source: Markelj et al. 2008.
MethodSolver solveRgbr;

/// Compares DRRs of the CTA's vessels, or of tubes, with the image by stochastic rank correlation inside a mask around
/// the vessels, using Nelder–Mead (ALGORITHMS §3.7). Source: Steininger et al. 2012.
MethodSolver solveAutoMask;

/// Matches the walls of the projected vessels to the image gradients by Powell's method (ALGORITHMS §3.10). Source:
/// Mitrović et al. 2013.
MethodSolver solveGradientMatching;

/// Minimizes the L2 distance between mixtures of oriented Gaussians of projected tree and traced vessels, coarse to
/// fine, by L-BFGS (ALGORITHMS §3.12). Source: Baka et al. 2014.
MethodSolver solveOgmm;

/// Gradient flow of continuous visual odometry: treats projected tree and traced vessels as functions on the image
/// plane and maximizes their inner product by gradient steps whose length comes from a Taylor series (ALGORITHMS
/// §3.16). Source: Ghaffari et al. 2019.
MethodSolver solveCvo;

/// Matches branches of the tree to traced curves by their graphs and fits the pose to the pairs; then moves the vessels
/// onto the curves, preserving lengths, and reports the displacement (ALGORITHMS §3.9). Source: Groher et al. 2009.
MethodSolver solveMatchedBranches;

/// Best-first search over sequences of matched branches, starting at a pair of nodes and fitting a pose to each
/// sequence; refines the best poses (ALGORITHMS §3.17). Based on the tree search of Zhu et al.
MethodSolver solveGraphMatching;

/// Searches with many poses (ALGORITHMS §3.13): an annealed particle filter around the initial pose, or a sweep of the
/// two out-of-plane angles that solves for the rest in each cell (based on Tian et al. 2022). Refines the best three.
MethodSolver solveParticle;

/// Finds the pose that aligns the vessels with the strongest ridges, using an evolution strategy (ALGORITHMS §3.11).
/// Source: Jomier et al. 2006.
MethodSolver solveEvolution;

/// Finds the path of a single guidewire or catheter through the tree, and the most likely pose near the previous
/// registered pose (ALGORITHMS §6.22).
MethodSolver solveWire;

}   // namespace angiopose::core
