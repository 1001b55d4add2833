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

    /// Makes a trial with the resampled curves as target, starting from the true pose.
    Trial makeTrial() const;
    /// Makes a trial with the exact projections of the tree's points as target, starting from the true pose.
    Trial makeExactTrial() const;

    Phantom scene;
    std::shared_ptr<const VesselTree> tree;
    Eigen::Vector3d centroid;
};

using Phantoms = std::shared_ptr<const std::vector<SharedPhantom>>;

/// Makes the trees P1, P2, … of one experiment, about 2000 points each.
Phantoms makePhantoms(std::uint64_t seed, int count);

/// Returns the random stream of trial number `trial` of a protocol. It is the same for every condition, which makes the
/// conditions comparable.
CounterRandom trialRandom(std::uint64_t protocolNumber, std::uint64_t seed, std::uint64_t trial);

/// Replaces the target with a degraded one and stores the resulting error bound.
void degradeTarget(const SharedPhantom& phantom, const CounterRandom& random, Trial& trial);

/// Returns a vector of the given length in a random direction.
Eigen::Vector3d randomDirection(double length, CounterRandom& random);

/// Traces the first frame of a simulated view with the real tracing and takes the initial pose from its header. If
/// tracing fails, the target stays empty and every method fails.
Trial tracedTrial(const SimulatedCase& view);

}   // namespace angiopose::core
