#include "io/volume/volume_axes.h"

#include "io/messages/says.h"
#include "io/support/numbers.h"

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace angiopose::io {
namespace {

constexpr double exactCosine = 1e-7;   // below: as good as perpendicular
constexpr double roundedCosine = 1.75e-3;   // 0.1 degrees

std::optional<core::Message> findBadSize(const Eigen::Vector3i& size)
{
    const std::string text =
        std::to_string(size.x()) + " x " + std::to_string(size.y()) + " x " + std::to_string(size.z()) + " voxels";
    if ((size.array() < 1).any()) {
        return says::volumeHeaderGives(text);
    }
    if ((size.array() < 2).any()) {
        return says::volumeSingleSlice(text);
    }
    const double count = size.cast<double>().prod();
    return count > static_cast<double>(maxVoxels) ? std::optional(says::volumeDeclares(text)) : std::nullopt;
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
    if (result.problem) {
        return result;
    }
    const Eigen::Vector3d spacing = steps.colwise().norm();
    const bool isFinite = steps.allFinite() && originInPatient.allFinite();
    if (!isFinite || spacing.minCoeff() < 1e-4 || spacing.maxCoeff() > 1e3 ||
        originInPatient.cwiseAbs().maxCoeff() > 1e6) {
        result.problem = says::volumeNoPlace();
        return result;
    }
    Eigen::Matrix3d axes = steps * spacing.cwiseInverse().asDiagonal();
    const double cosine = largestCosine(axes);
    if (cosine > roundedCosine) {
        result.problem = says::volumeSkewed(core::Quantity{std::acos(cosine) * 180.0 / std::numbers::pi, 1, "°"});
        return result;
    }
    result.geometry = {size, spacing, originInPatient, cosine > exactCosine ? nearestOrthonormal(axes) : axes};
    return result;
}

}   // namespace angiopose::io