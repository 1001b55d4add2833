#include "io/volume/volume_axes.h"

#include "io/messages/messages.h"
#include "io/support/numbers.h"

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace angiopose::io {
namespace {

constexpr double exactCosine = 1e-7;   // axes with a smaller cosine are considered perpendicular
constexpr double roundedCosine = 1.75e-3;   // cosine of the maximum deviation from a right angle, 0.1°

std::optional<core::Message> findBadSize(const Eigen::Vector3i& size)
{
    const std::string text =
        std::to_string(size.x()) + " x " + std::to_string(size.y()) + " x " + std::to_string(size.z()) + " voxels";
    if ((size.array() < 1).any()) {
        return messages::volumeHeaderGives(text);
    }
    if ((size.array() < 2).any()) {
        return messages::volumeSingleSlice(text);
    }
    const double count = size.cast<double>().prod();
    return count > static_cast<double>(maxVoxels) ? std::optional(messages::volumeDeclares(text)) : std::nullopt;
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

double millimetersPer(std::string_view unit, core::Messages& warnings)
{
    using Length = std::pair<std::string_view, double>;
    static constexpr Length prefixes[] = {{"", 1e3},      {"deci", 100.0}, {"centi", 10.0},
                                          {"milli", 1.0}, {"micro", 1e-3}, {"nano", 1e-6}};
    static constexpr Length lengths[] = {{"", 1.0},           {"?", 1.0},       {"m", 1e3},        {"dm", 100.0},
                                         {"cm", 10.0},        {"mm", 1.0},      {"um", 1e-3},      {"\xc2\xb5m", 1e-3},
                                         {"\xce\xbcm", 1e-3}, {"micron", 1e-3}, {"microns", 1e-3}, {"nm", 1e-6},
                                         {"in", 25.4},        {"inch", 25.4},   {"inches", 25.4}};
    unit = trimmed(unit);
    const std::string name = toLower(unit);
    for (const auto& [length, mm] : lengths) {
        if (name == length) {
            return mm;
        }
    }
    for (const auto& [prefix, mm] : prefixes) {
        const std::string_view rest = name.starts_with(prefix) ? std::string_view(name).substr(prefix.size()) : "";
        if (rest == "meter" || rest == "meters" || rest == "metre" || rest == "metres") {
            return mm;
        }
    }
    const core::Message unknown = messages::volumeUnitUnknown(unit.substr(0, 24));
    if (std::ranges::none_of(warnings, [&](const core::Message& said) { return said.text() == unknown.text(); })) {
        warnings.push_back(unknown);
    }
    return 1.0;
}

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
        result.problem = messages::volumeNoPlace();
        return result;
    }
    Eigen::Matrix3d axes = steps * spacing.cwiseInverse().asDiagonal();
    const double cosine = largestCosine(axes);
    if (cosine > roundedCosine) {
        result.problem = messages::volumeSkewed(core::Quantity{std::acos(cosine) * 180.0 / std::numbers::pi, 1, "°"});
        return result;
    }
    result.geometry = {size, spacing, originInPatient, cosine > exactCosine ? nearestOrthonormal(axes) : axes};
    return result;
}

}   // namespace angiopose::io
