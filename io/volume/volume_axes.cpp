#include "io/volume/volume_axes.h"

#include "io/support/numbers.h"

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace angiopose::io {
namespace {

constexpr double exactCosine = 1e-7;   // below: as good as perpendicular
constexpr double roundedCosine = 1.75e-3;   // 0.1 degrees

std::string findBadSize(const Eigen::Vector3i& size)
{
    const std::string text =
        std::to_string(size.x()) + " x " + std::to_string(size.y()) + " x " + std::to_string(size.z()) + " voxels";
    if ((size.array() < 1).any()) {
        return "its header gives " + text + ". The file is damaged; export it again.";
    }
    if ((size.array() < 2).any()) {
        return "it has " + text + ": a single slice is no volume. Choose the whole scan.";
    }
    const double count = size.cast<double>().prod();
    return count > static_cast<double>(maxVoxels)
               ? "it declares " + text + ", more than this program holds. Crop the scan to the vessels."
               : std::string();
}

double largestCosine(const Eigen::Matrix3d& axes)
{
    return std::max({std::abs(axes.col(0).dot(axes.col(1))), std::abs(axes.col(0).dot(axes.col(2))),
                     std::abs(axes.col(1).dot(axes.col(2)))});
}

Eigen::Matrix3d nearestOrthonormal(const Eigen::Matrix3d& axes)
{
    const Eigen::JacobiSVD<Eigen::Matrix3d> svd(axes, Eigen::ComputeFullU | Eigen::ComputeFullV);
    return svd.matrixU() * svd.matrixV().transpose();
}

}   // namespace

AxesResult geometryFromSteps(const Eigen::Vector3i& size, const Eigen::Matrix3d& steps,
                             const Eigen::Vector3d& originInPatient)
{
    AxesResult result;
    result.problem = findBadSize(size);
    if (!result.problem.empty()) {
        return result;
    }
    const Eigen::Vector3d spacing = steps.colwise().norm();
    const bool isFinite = steps.allFinite() && originInPatient.allFinite();
    if (!isFinite || spacing.minCoeff() < 1e-4 || spacing.maxCoeff() > 1e3 ||
        originInPatient.cwiseAbs().maxCoeff() > 1e6) {
        result.problem = "its header gives no usable voxel size or place. Export the volume again.";
        return result;
    }
    Eigen::Matrix3d axes = steps * spacing.cwiseInverse().asDiagonal();
    const double cosine = largestCosine(axes);
    if (cosine > roundedCosine) {
        result.problem = "its axes are " + toText(std::round(std::acos(cosine) * 1800.0 / std::numbers::pi) / 10.0) +
                         "° apart instead of 90°. Resample the volume to perpendicular axes.";
        return result;
    }
    result.geometry = {size, spacing, originInPatient, cosine > exactCosine ? nearestOrthonormal(axes) : axes};
    return result;
}

}   // namespace angiopose::io