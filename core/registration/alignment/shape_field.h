#pragma once

#include "core/registration/alignment/residual_noise.h"

#include <Eigen/Core>

namespace angiopose::core {

/// The residuals of a tree that is bent smoothly: the projected vessel lies beside its true place by a random field in
/// the image plane, Gaussian, alike within about 40 mm in space. The field is constant over short blocks of a branch.
/// Everything is in units of information: weights are divided by the variance of a row, the prior adds 1/σ².
/// Parameters: 6 of the pose, or 9 with those of the camera after them.
template <int Parameters>
class ShapeFieldOf {
public:
    using Equations = EquationsOf<Parameters>;

    static constexpr double reachMm = 40.0;   ///< of heart and breathing (ALGORITHMS §4.4)

    ShapeFieldOf(const std::vector<ResidualRow>& rows, double rowVariance);

    /// Normal equations of the parameters with the field eliminated (generalised least squares); `offsetPx`: its
    /// standard deviation.
    Equations equations(double offsetPx);

    /// The standard deviation that makes the residuals most likely after the best parameters have been taken out
    /// (restricted maximum likelihood); `prior`: what else is known about them.
    double likelyOffsetPx(const Equations& prior);

private:
    void eliminate(double offsetPx);
    double logLikelihood(double offsetPx, const Equations& prior);

    static constexpr int withResidual = Parameters + 1;
    using Squares = Eigen::Matrix<double, withResidual, withResidual>;
    using Blocks = Eigen::Matrix<double, Eigen::Dynamic, withResidual>;
    Squares plain_ = Squares::Zero();   ///< Σ of [g r]ᵀ[g r] over all rows
    Squares left_;   ///< the same with the field eliminated
    Blocks blocks_;   ///< Σ of [g r] over each block, divided by the root of its weight
    Eigen::MatrixXd kernel_;   ///< covariance of the blocks for a field of 1 px, scaled by the roots of their weights
    Eigen::MatrixXd factor_;
    double logDeterminant_ = 0.0;
};

using ShapeField = ShapeFieldOf<6>;

extern template class ShapeFieldOf<6>;
extern template class ShapeFieldOf<9>;

}   // namespace angiopose::core