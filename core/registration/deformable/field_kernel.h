#pragma once

#include "core/vessel/tree_knots.h"

#include <Eigen/Core>
#include <array>
#include <cstddef>

namespace angiopose::core {

/// Covariance model of vessel motion (ALGORITHMS §11.1). The motion along each axis is a sum of Gaussian processes:
/// smooth body motion at three length scales in 3-D, and motion along the tree as caused by a guidewire.
inline constexpr std::array<double, 3> motionLengthsMm{80.0, 40.0, 20.0};
inline constexpr double motionAlongTreeMm = 60.0;
inline constexpr std::size_t motionCount = motionLengthsMm.size() + 1;   ///< the last one acts along the tree

/// Variance of each motion component, mm² per axis.
using MotionVariances = std::array<double, motionCount>;

/// Covariances between the knots of a tree for motions of unit variance; single precision suffices at any noise level.
class FieldKernel {
public:
    explicit FieldKernel(const TreeKnots& knots);

    const Eigen::MatrixXf& kernelOf(std::size_t motion) const { return kernels_[motion]; }

    /// Returns the summed covariances between knots, mm² per axis.
    Eigen::MatrixXf combined(const MotionVariances& variances) const;

private:
    std::array<Eigen::MatrixXf, motionCount> kernels_;
};

}   // namespace angiopose::core
