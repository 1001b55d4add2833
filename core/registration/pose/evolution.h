#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <functional>

namespace angiopose::core {

struct EvolutionSettings {
    int population = 16;
    int maxEvaluations = 3000;
    double minStepSize = 1e-3;   ///< width of the search distribution at which the search ends, in units of x
    std::uint64_t seed = 1;
};

using EvolutionCost = std::function<double(const Eigen::VectorXd& x)>;
using StopCheck = std::function<bool()>;

/// Minimizes by covariance matrix adaptation with cumulative step-size control, starting from the normal distribution
/// about 0 with unit variance (Hansen, "The CMA evolution strategy: a tutorial", 2016). Returns true if the search
/// converged, false if it ran out of evaluations or was stopped. Of the libraries with this algorithm, Debian 12
/// packages only pagmo2 (neither libcmaes nor ensmallen; NLopt lacks the algorithm). To replace these hundred lines in
/// one comparison method, pagmo2 would require TBB, Boost.Serialization and bounded problems, and it cannot be stopped
/// within a generation.
bool minimizeCmaEs(const EvolutionCost& cost, Eigen::Index dimensions, const EvolutionSettings& options,
                   const StopCheck& isStopped);

/// Minimizes with one parent and one child per generation: a success widens the search by a factor of 1.05, a failure
/// narrows it by the fourth root of 1.05, both along the step taken (Styner et al. 2000).
bool minimizeOnePlusOneEs(const EvolutionCost& cost, Eigen::Index dimensions, const EvolutionSettings& options,
                          const StopCheck& isStopped);

}   // namespace angiopose::core
