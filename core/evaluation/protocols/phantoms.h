#pragma once

#include "core/evaluation/trial/run_record.h"
#include "core/simulation/phantom.h"
#include "core/simulation/simulated_case.h"
#include "core/support/random.h"

#include <memory>
#include <vector>

namespace angiopose::core {

/// A phantom whose tree trials can share.
struct SharedPhantom {
    explicit SharedPhantom(Phantom phantom);

    /// A trial on the curves sampled anew, starting from the true pose.
    Trial makeTrial() const;
    /// The same on the projections of the tree's own points.
    Trial makeExactTrial() const;

    Phantom scene;
    std::shared_ptr<const VesselTree> tree;
    Eigen::Vector3d centroid;
};

using Phantoms = std::shared_ptr<const std::vector<SharedPhantom>>;

/// Trees P1, P2, … of one experiment, about 2000 points each.
Phantoms makePhantoms(std::uint64_t seed, int count);

/// What trial number `trial` of a protocol draws from: the same for every condition, so that these compare.
CounterRandom trialRandom(std::uint64_t protocolNumber, std::uint64_t seed, std::uint64_t trial);

/// Replaces the target by a degraded one and says what it allows.
void degradeTarget(const SharedPhantom& phantom, const CounterRandom& random, Trial& trial);

/// A vector of the given length in a random direction.
Eigen::Vector3d randomDirection(double length, CounterRandom& random);

/// The first frame of a simulated view through the real tracing, the start pose as its header gives it. A view whose
/// tracing fails keeps an empty target: every method then fails on it.
Trial tracedTrial(const SimulatedCase& view);

}   // namespace angiopose::core
