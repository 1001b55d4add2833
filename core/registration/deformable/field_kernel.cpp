#include "core/registration/deformable/field_kernel.h"

namespace angiopose::core {

FieldKernel::FieldKernel(const TreeKnots& knots)
{
    const auto count = static_cast<Eigen::Index>(knots.size());
    Eigen::Matrix3Xf positions(3, count);
    for (Eigen::Index k = 0; k < count; ++k) {
        positions.col(k) = knots.positions[static_cast<std::size_t>(k)].cast<float>();
    }
    Eigen::MatrixXf squared(count, count);
    for (Eigen::Index k = 0; k < count; ++k) {
        squared.col(k) = (positions.colwise() - positions.col(k)).colwise().squaredNorm().transpose();
    }
    // Each length is half the previous one; each kernel is therefore the fourth power of the previous one.
    kernels_[0] = (static_cast<float>(-0.5 / (motionLengthsMm[0] * motionLengthsMm[0])) * squared.array()).exp();
    kernels_[1] = kernels_[0].array().square().square();
    kernels_[2] = kernels_[1].array().square().square();
    kernels_[3] = (-1.0 / motionAlongTreeMm * knots.distancesAlongTree().array()).cast<float>().exp();
}

Eigen::MatrixXf FieldKernel::combined(const MotionVariances& variances) const
{
    Eigen::MatrixXf sum = static_cast<float>(variances[0]) * kernels_[0];
    for (std::size_t m = 1; m < motionCount; ++m) {
        sum += static_cast<float>(variances[m]) * kernels_[m];
    }
    return sum;
}

}   // namespace angiopose::core
