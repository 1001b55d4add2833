#pragma once

#include "core/geometry/rigid_transform.h"

namespace angiopose::core {

/// Quadratic model of a least-squares cost: cost(x) ≈ cost(0) + 2 gᵀx + xᵀHx. Only the lower triangle of H is used.
template <int Parameters>
struct EquationsOf {
    Eigen::Matrix<double, Parameters, Parameters> hessian = Eigen::Matrix<double, Parameters, Parameters>::Zero();
    Eigen::Vector<double, Parameters> gradient = Eigen::Vector<double, Parameters>::Zero();
};

/// Normal equations about a pose: x = (ω rad, υ mm), or any other six parameters.
using NormalEquations = EquationsOf<6>;

/// Normal equations of a pose and of the error of its camera, in this order (see CameraError).
using CameraEquations = EquationsOf<9>;

/// Normal equations with any number of parameters; both triangles of the Hessian are filled.
struct StackedEquations {
    Eigen::MatrixXd hessian;
    Eigen::VectorXd gradient;
};

/// Free parameters: all six, or only the first three (rotation).
enum class Freedom { Rotation, Full };

/// Returns the minimizer of the model damped by μ·diag(H), which is invariant to the units of x (ALGORITHMS §1).
/// Parameters without influence on the data remain zero.
Vector6d dampedStep(const NormalEquations& equations, double damping, Freedom freedom = Freedom::Full);

/// Basis of the allowed steps, one per column.
using StepBasis = Eigen::Matrix<double, 6, Eigen::Dynamic, Eigen::ColMajor, 6, 6>;

/// Overload restricted to linear combinations of the columns of `basis`, which must be independent.
Vector6d dampedStep(const NormalEquations& equations, double damping, const StepBasis& basis);

/// Overload for any number of parameters.
Eigen::VectorXd dampedStep(const StackedEquations& equations, double damping);

/// Returns the decrease that the undamped model predicts for a step; positive if the step lowers the cost.
double predictedDecrease(const NormalEquations& equations, const Vector6d& step);
double predictedDecrease(const StackedEquations& equations, const Eigen::VectorXd& step);

/// Nielsen's damping schedule (ALGORITHMS §1; Madsen, Nielsen, Tingleff 2004).
class Damping {
public:
    double factor() const { return factor_; }
    void accept(double gain);   ///< `gain` is the ratio of actual to predicted decrease
    void reject();
    void reset() { *this = Damping(); }

private:
    double factor_ = 1e-3;
    double growth_ = 2.0;
};

}   // namespace angiopose::core
