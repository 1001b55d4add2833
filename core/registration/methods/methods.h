#pragma once

#include "core/registration/methods/method.h"

// Every method, each in a file of its own; the table in method_table.cpp says what users call them.
namespace angiopose::core {

/// Our own method (ALGORITHMS §6): coarse search → robust refinement of the best hypotheses → full refinement of the
/// best one, all about the tree's centroid.
MethodSolver solveAngioPose;

/// DynaWeightPnP, ALGORITHMS §3.2: a turn about the source, then auxiliary points with held matches and all points with
/// fresh ones take turns.
MethodSolver solveDynaWeight;

/// DynaWeightPnP*, ALGORITHMS §3.1: kernel PnP with all points from the start pose.
MethodSolver solveIterativePnp;

/// Gradient ascent of the mean kernel between projected tree and target, coarse to fine (ALGORITHMS §3.3), or of the
/// brightness at each vessel's own width (§3.4, option `nicpImage`). Source: Aylward et al. 2003; as Song and Ghaffari
/// describe it.
MethodSolver solveNicp;

/// The same inside the alternating search (§3.5).
MethodSolver solveNicpAlternating;

/// Least Huber loss of the distances to the nearest traced vessel, by damped steps with fresh matches; or least squared
/// distances by L-BFGS; with an affine stage on request (ALGORITHMS §3.6). Source: Rivest-Hénault et al. 2012.
MethodSolver solveDtIcp;

/// What a good engineer builds in an afternoon from library parts: nearest neighbours by nanoflann, then OpenCV's SQPNP
/// (Terzakis, Lourakis 2020) on the pairs, repeated until the pairs stay (ALGORITHMS §3.14). With the whole tree in the
/// image and a start close by it is quick and exact already: what other methods must beat.
MethodSolver solveAssembledIcp;

/// Finds edges of the image along the normals of the vessel walls, chooses a pose by RANSAC with a gradient-matching
/// score, and repeats with a shorter reach (ALGORITHMS §3.8). Source: Markelj et al. 2008.
MethodSolver solveRgbr;

/// Compares radiographs of the CTA's vessels, or of tubes, with the image by stochastic rank correlation inside a mask
/// around them; Nelder–Mead (ALGORITHMS §3.7). Source: Steininger et al. 2012.
MethodSolver solveAutoMask;

/// Matches the walls of the projected vessels with the gradients of the image; Powell's method (ALGORITHMS §3.10).
/// Source: Mitrović et al. 2013.
MethodSolver solveGradientMatching;

/// Least L2 distance between mixtures of oriented Gaussians of projected tree and traced vessels, coarse to fine, by
/// L-BFGS (ALGORITHMS §3.12). Source: Baka et al. 2014.
MethodSolver solveOgmm;

/// Continuous visual odometry's gradient flow: projected tree and traced vessels as functions of the image plane, their
/// inner product climbed along its gradient with steps from a Taylor series (ALGORITHMS §3.16). Source: Ghaffari et al.
/// 2019.
MethodSolver solveCvo;

/// Branches of the tree are matched with traced curves by their graphs, the pose fits the pairs; then the vessels are
/// moved onto them, lengths kept, and the result tells how far (ALGORITHMS §3.9). Source: Groher et al. 2009.
MethodSolver solveMatchedBranches;

/// Searches, best first, over sequences of branches matched from a pair of nodes on, a pose from each; the best are
/// refined (ALGORITHMS §3.17). After Zhu et al.'s tree search.
MethodSolver solveGraphMatching;

/// Searches by many poses at once (ALGORITHMS §3.13): an annealed particle filter around the start, or a walk over the
/// two out-of-plane angles with the rest solved in each cell (after Tian et al. 2022). The best three are refined.
MethodSolver solveParticle;

/// Searches the pose under which vessels lie on the brightest ridges by an evolution strategy (ALGORITHMS §3.11).
/// Source: Jomier et al. 2006.
MethodSolver solveEvolution;

/// Finds the way of the tree that a single wire or catheter takes, and the most likely pose near the last full one
/// (ALGORITHMS §6.22).
MethodSolver solveWire;

}   // namespace angiopose::core
