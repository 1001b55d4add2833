#pragma once

#include "core/registration/alignment/residual_noise.h"

#include <Eigen/Core>

namespace angiopose::core {

/// The residuals of a tree that is bent smoothly: the projected vessel lies beside its true place by a random field in
/// the image plane, Gaussian, alike within about 40 mm in space. The field is constant over short blocks of a branch.
/// Everything is in units of information: weights are divided by the variance of a row, the prior adds 1/σ².
class ShapeField {
public:
    static constexpr double reachMm = 40.0;   ///< of heart and breathing (ALGORITHMS §4.4)

    ShapeField(const std::vector<ResidualRow>& rows, double rowVariance);

    /// Normal equations of the pose with the field eliminated (generalised least squares); `offsetPx`: its standard
    /// deviation.
    NormalEquations equations(double offsetPx);

    /// The standard deviation that makes the residuals most likely after the best pose has been taken out (restricted
    /// maximum likelihood); `prior`: what else is known about the pose.
    double likelyOffsetPx(const NormalEquations& prior);

private:
    void eliminate(double offsetPx);
    double logLikelihood(double offsetPx, const NormalEquations& prior);

    using Block7 = Eigen::Matrix<double, Eigen::Dynamic, 7>;
    Eigen::Matrix<double, 7, 7> plain_ = Eigen::Matrix<double, 7, 7>::Zero();   ///< Σ of [g r]ᵀ[g r] over all rows
    Eigen::Matrix<double, 7, 7> left_;   ///< the same with the field eliminated
    Block7 blocks_;   ///< Σ of [g r] over each block, divided by the root of its weight
    Eigen::MatrixXd kernel_;   ///< covariance of the blocks for a field of 1 px, scaled by the roots of their weights
    Eigen::MatrixXd factor_;
    double logDeterminant_ = 0.0;
};

}   // namespace angiopose::core