#pragma once

#include <Eigen/Core>
#include <functional>

namespace angiopose::core {

/// Well-known minimisers, from NLopt: simplex of Nelder and Mead; Powell's line searches along conjugate directions in
/// Brent's form (PRAXIS); L-BFGS.
enum class Minimizer { NelderMead, Powell, Lbfgs };

struct MinimizeOptions {
    Minimizer minimizer = Minimizer::NelderMead;
    double firstStep = 1.0;   ///< size of the first simplex or line search, in units of x
    double tolerance = 1e-3;   ///< ends when x moves less, in units of x
    double relativeTolerance = 0.0;   ///< ends when the cost changes by a smaller share of itself; 0: not asked
    int maxEvaluations = 1000;
};

/// Cost of x; fills the gradient where one is asked for (only L-BFGS asks, others pass an empty vector).
using CostFunction = std::function<double(const Eigen::VectorXd& x, Eigen::VectorXd& gradient)>;

struct Minimum {
    Eigen::VectorXd x;
    double cost = 0.0;
    bool isConverged = false;   ///< false: out of evaluations, stopped, or stuck
};

/// Minimises from `start`. Ends at once when `isStopped` says so after an evaluation. Same input, same bits.
Minimum minimize(const CostFunction& cost, const Eigen::VectorXd& start, const MinimizeOptions& options,
                 const std::function<bool()>& isStopped);

}   // namespace angiopose::core