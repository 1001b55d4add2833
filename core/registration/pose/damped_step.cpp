#include "core/registration/pose/damped_step.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace angiopose::core {
namespace {

constexpr double minFactor = 1e-10;
constexpr double maxFactor = 1e10;

/// Solves in parameters scaled to a unit diagonal, because raw radians and millimeters worsen the condition number by
/// 1e9. `hessian` is symmetric with both triangles filled.
template <class Matrix, class Vector>
Vector solveScaled(Matrix hessian, const Vector& gradient, double damping)
{
    const double tiny = 1e-300;
    const Vector scale = hessian.diagonal().unaryExpr([tiny](double h) { return h > tiny ? 1.0 / std::sqrt(h) : 0.0; });
    hessian = scale.asDiagonal() * hessian * scale.asDiagonal();
    hessian.diagonal().setConstant(1.0 + damping);
    const Vector scaledGradient = scale.cwiseProduct(gradient);
    return -scale.cwiseProduct(hessian.ldlt().solve(scaledGradient));
}

template <int Count>
Vector6d stepOfFirst(const NormalEquations& equations, double damping)
{
    using Matrix = Eigen::Matrix<double, Count, Count>;
    using Vector = Eigen::Matrix<double, Count, 1>;
    const Matrix hessian = equations.hessian.topLeftCorner<Count, Count>().template selfadjointView<Eigen::Lower>();
    Vector6d step = Vector6d::Zero();
    step.head<Count>() = solveScaled<Matrix, Vector>(hessian, equations.gradient.head<Count>(), damping);
    return step;
}

}   // namespace

Vector6d dampedStep(const NormalEquations& equations, double damping, Freedom freedom)
{
    return freedom == Freedom::Full ? stepOfFirst<6>(equations, damping) : stepOfFirst<3>(equations, damping);
}

Vector6d dampedStep(const NormalEquations& equations, double damping, const StepBasis& basis)
{
    using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, 6, 6>;
    using Vector = Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, 6, 1>;
    const Matrix6d full = equations.hessian.selfadjointView<Eigen::Lower>();
    const Matrix hessian = basis.transpose() * full * basis;
    return basis * solveScaled<Matrix, Vector>(hessian, basis.transpose() * equations.gradient, damping);
}

Eigen::VectorXd dampedStep(const StackedEquations& equations, double damping)
{
    return solveScaled<Eigen::MatrixXd, Eigen::VectorXd>(equations.hessian, equations.gradient, damping);
}

double predictedDecrease(const StackedEquations& equations, const Eigen::VectorXd& step)
{
    return -2.0 * equations.gradient.dot(step) - step.dot(equations.hessian * step);
}

double predictedDecrease(const NormalEquations& equations, const Vector6d& step)
{
    return -2.0 * equations.gradient.dot(step) - step.dot(equations.hessian.selfadjointView<Eigen::Lower>() * step);
}

void Damping::accept(double gain)
{
    const double overshoot = 2.0 * gain - 1.0;
    factor_ = std::max(minFactor, factor_ * std::max(1.0 / 3.0, 1.0 - overshoot * overshoot * overshoot));
    growth_ = 2.0;
}

void Damping::reject()
{
    factor_ = std::min(maxFactor, factor_ * growth_);
    growth_ *= 2.0;
}

}   // namespace angiopose::core
