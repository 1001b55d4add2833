#pragma once

#include "core/evaluation/trial/run_record.h"
#include "core/simulation/phantom.h"
#include "core/simulation/simulated_case.h"
#include "core/support/random.h"

#include <memory>
#include <vector>

namespace angiopose::core {

/// A phantom shared by all its trials.
struct SharedPhantom {
    explicit SharedPhantom(Phantom phantom);

    /// Creates a trial whose target is the resampled curves, starting from the true pose.
    Trial makeTrial() const;
    /// Creates a trial whose target is the exact projections of the tree's points, starting from the true pose.
    Trial makeExactTrial() const;

    Phantom scene;
    std::shared_ptr<const VesselTree> tree;
    Eigen::Vector3d centroid;
};

using Phantoms = std::shared_ptr<const std::vector<SharedPhantom>>;

/// Creates the trees P1, P2, … of one experiment, each with about 2000 points.
Phantoms makePhantoms(std::uint64_t seed, int count);

/// Returns the random stream of trial number `trial` of a protocol. The stream is the same for every condition, which
/// makes the conditions comparable.
CounterRandom trialRandom(std::uint64_t protocolNumber, std::uint64_t seed, std::uint64_t trial);

/// Replaces the target with a degraded one and stores the resulting error bound.
void degradeTarget(const SharedPhantom& phantom, const CounterRandom& random, Trial& trial);

/// Returns a vector of the given length in a random direction.
Eigen::Vector3d randomDirection(double length, CounterRandom& random);

/// Creates a trial by tracing the first frame of a simulated view with the actual tracing algorithm and taking the
/// initial pose from its header. If tracing fails, the target stays empty and every method fails.
Trial makeTracedTrial(const SimulatedCase& view);

}   // namespace angiopose::core
