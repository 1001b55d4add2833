#pragma once

#include "core/registration/alignment/residual_noise.h"

#include <Eigen/Core>

namespace angiopose::core {

/// Residual model of a smoothly deformed tree: a Gaussian random field in the image plane, correlated over about 40 mm
/// in 3-D, displaces the projected vessels. The field is constant over short blocks of a branch. All values are in
/// units of information: weights are divided by the variance of a row, and the prior adds 1/σ². The parameters are the
/// 6 of the pose, optionally followed by 3 of the camera.
template <int Parameters>
class ShapeFieldOf {
public:
    using Equations = EquationsOf<Parameters>;

    static constexpr double reachMm = 40.0;   ///< correlation length of heart and breathing motion (ALGORITHMS §4.4)

    ShapeFieldOf(const std::vector<ResidualRow>& rows, double rowVariance);

    /// Returns the normal equations of the parameters with the field eliminated (generalized least squares); `offsetPx`
    /// is the standard deviation of the field.
    Equations equations(double offsetPx);

    /// Returns the standard deviation of the field by restricted maximum likelihood, with the pose parameters
    /// eliminated; `prior` holds additional information about these parameters.
    double estimateOffsetPx(const Equations& prior);

private:
    void eliminate(double offsetPx);
    double logLikelihood(double offsetPx, const Equations& prior);

    static constexpr int columnCount = Parameters + 1;
    using Squares = Eigen::Matrix<double, columnCount, columnCount>;
    using Blocks = Eigen::Matrix<double, Eigen::Dynamic, columnCount>;
    Squares gram_ = Squares::Zero();   ///< Σ of [g r]ᵀ[g r] over all rows
    Squares reducedGram_;   ///< the same sum with the field eliminated
    Blocks blocks_;   ///< Σ [g r] over each block, divided by the square root of the block's weight
    Eigen::MatrixXd
        kernel_;   ///< covariance of the blocks for a field of 1 px, scaled by the square roots of their weights
    Eigen::MatrixXd factor_;
    double logDeterminant_ = 0.0;
};

using ShapeField = ShapeFieldOf<6>;

extern template class ShapeFieldOf<6>;
extern template class ShapeFieldOf<9>;

}   // namespace angiopose::core
