#pragma once

#include <Eigen/Core>
#include <functional>

namespace angiopose::core {

/// Standard minimizers from NLopt: Nelder–Mead simplex; Powell's line searches along conjugate directions in Brent's
/// version (PRAXIS); L-BFGS.
enum class Minimizer { NelderMead, Powell, Lbfgs };

struct MinimizeOptions {
    Minimizer minimizer = Minimizer::NelderMead;
    double firstStep = 1.0;   ///< size of the first simplex or line search, in units of x
    double tolerance = 1e-3;   ///< ends when x changes by less, in units of x
    double relativeTolerance = 0.0;   ///< ends when the cost changes by a smaller fraction of itself; 0: disabled
    int maxEvaluations = 1000;
};

/// Cost of x; fills the gradient on request (only L-BFGS needs it, the others pass an empty vector).
using CostFunction = std::function<double(const Eigen::VectorXd& x, Eigen::VectorXd& gradient)>;

struct Minimum {
    Eigen::VectorXd x;
    double cost = 0.0;
    bool isConverged = false;   ///< false: out of evaluations, stopped, or stuck
};

/// Minimizes from `start`. Ends immediately if `isStopped` returns true after an evaluation. The result is bitwise
/// reproducible.
Minimum minimize(const CostFunction& cost, const Eigen::VectorXd& start, const MinimizeOptions& options,
                 const std::function<bool()>& isStopped);

}   // namespace angiopose::core