#pragma once

#include "core/vessel/tree_knots.h"

#include <Eigen/Core>
#include <array>
#include <cstddef>

namespace angiopose::core {

/// Covariance model of vessel motion (ALGORITHMS §11.1): a Gaussian process per axis, the sum of smooth body motion at
/// three length scales in space and of motion along the tree, such as a wire causes.
inline constexpr std::array<double, 3> motionLengthsMm{80.0, 40.0, 20.0};
inline constexpr double motionAlongTreeMm = 60.0;
inline constexpr std::size_t motionCount = motionLengthsMm.size() + 1;   ///< the last one acts along the tree

/// Variances of the motions, mm² per axis.
using MotionVariances = std::array<double, motionCount>;

/// Covariances between the knots of a tree for motions of unit variance; single precision is much finer than any noise.
class FieldKernel {
public:
    explicit FieldKernel(const TreeKnots& knots);

    const Eigen::MatrixXf& of(std::size_t motion) const { return kernels_[motion]; }

    /// Covariances per axis, mm².
    Eigen::MatrixXf combined(const MotionVariances& variances) const;

private:
    std::array<Eigen::MatrixXf, motionCount> kernels_;
};

}   // namespace angiopose::core
