#pragma once

#include <Eigen/Core>
#include <functional>

namespace angiopose::core {

/// Standard minimizers from NLopt: Nelder–Mead simplex; Powell's line searches along conjugate directions in Brent's
/// version (PRAXIS); L-BFGS.
enum class Minimizer { NelderMead, Powell, Lbfgs };

struct MinimizeOptions {
    Minimizer minimizer = Minimizer::NelderMead;
    double firstStep = 1.0;   ///< size of the initial simplex or line search, in units of x
    double tolerance = 1e-3;   ///< change of x below which the search ends, in units of x
    double relativeTolerance = 0.0;   ///< relative change of the cost below which the search ends; 0 disables this test
    int maxEvaluations = 1000;
};

/// Returns the cost of x and fills the gradient unless the vector is empty; only L-BFGS requests the gradient.
using CostFunction = std::function<double(const Eigen::VectorXd& x, Eigen::VectorXd& gradient)>;

struct Minimum {
    Eigen::VectorXd x;
    double cost = 0.0;
    bool isConverged = false;   ///< false if the search ran out of evaluations, was stopped or got stuck
};

/// Minimizes from `start`. Ends as soon as `isStopped` returns true after an evaluation. Bitwise reproducible.
Minimum minimize(const CostFunction& cost, const Eigen::VectorXd& start, const MinimizeOptions& options,
                 const std::function<bool()>& isStopped);

}   // namespace angiopose::core
