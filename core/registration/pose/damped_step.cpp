#include "core/registration/pose/damped_step.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace core {
namespace {

constexpr double minFactor = 1e-10;
constexpr double maxFactor = 1e10;

/// Solves in the parameters scaled to unit diagonal: raw radians and millimetres differ by 1e9 in condition.
template <int Count>
Vector6d solveScaled(const NormalEquations& equations, double damping)
{
    using Matrix = Eigen::Matrix<double, Count, Count>;
    using Vector = Eigen::Matrix<double, Count, 1>;
    const Vector diagonal = equations.hessian.diagonal().head<Count>();
    const double tiny = 1e-300;
    const Vector scale = diagonal.unaryExpr([tiny](double h) { return h > tiny ? 1.0 / std::sqrt(h) : 0.0; });

    Matrix scaled = equations.hessian.topLeftCorner<Count, Count>().template selfadjointView<Eigen::Lower>();
    scaled = scale.asDiagonal() * scaled * scale.asDiagonal();
    scaled.diagonal().setConstant(1.0 + damping);
    const Vector scaledGradient = scale.cwiseProduct(equations.gradient.head<Count>());

    Vector6d step = Vector6d::Zero();
    step.head<Count>() = -scale.cwiseProduct(scaled.ldlt().solve(scaledGradient));
    return step;
}

}   // namespace

Vector6d dampedStep(const NormalEquations& equations, double damping, Freedom freedom)
{
    return freedom == Freedom::Full ? solveScaled<6>(equations, damping) : solveScaled<3>(equations, damping);
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

}   // namespace core
