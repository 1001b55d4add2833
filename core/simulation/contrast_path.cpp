#include "core/simulation/contrast_path.h"

#include "core/simulation/smooth_step.h"
#include "core/simulation/splat_disc.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace angiopose::core {
namespace {

constexpr double splatSpacingMm = 0.25;
constexpr double heartRateHz = 1.15;
constexpr double pulsation = 0.12;   ///< relative decrease of the concentration during each heartbeat

ContrastPoint between(const ContrastPoint& a, const ContrastPoint& b, double fraction)
{
    const auto mix = [fraction](const auto& x, const auto& y) { return ((1.0 - fraction) * x + fraction * y); };
    return {mix(a.pointInPatient, b.pointInPatient), mix(a.radiusMm, b.radiusMm), mix(a.opacity, b.opacity),
            mix(a.pathMm, b.pathMm)};
}

}   // namespace

double Bolus::concentration(double pathMm, double timeS) const
{
    const double sinceArrivalS = timeS - pathMm / speedMmPerS;
    const double filled = smoothStep(sinceArrivalS / riseS + 0.5);
    const double washed = std::exp(-std::max(0.0, sinceArrivalS - injectionS) / washoutS);
    const double beat = 1.0 - pulsation * (0.5 + 0.5 * std::sin(2.0 * std::numbers::pi * heartRateHz * sinceArrivalS));
    return filled * washed * beat;
}

ImageF contrastThicknessMm(const std::vector<ContrastPath>& paths, const Bolus& bolus, double timeS,
                           const ProjectionCamera& camera, const RigidTransform& cameraFromPatient)
{
    ImageF thicknessMm(camera.width, camera.height);
    for (const ContrastPath& path : paths) {
        for (std::size_t i = 1; i < path.size(); ++i) {
            const double lengthMm = (path[i].pointInPatient - path[i - 1].pointInPatient).norm();
            const int pieces = std::max(1, static_cast<int>(std::ceil(lengthMm / splatSpacingMm)));
            for (int k = 0; k < pieces; ++k) {
                const ContrastPoint piece = between(path[i - 1], path[i], (k + 0.5) / pieces);
                const double dose = piece.opacity * bolus.concentration(piece.pathMm, timeS) * lengthMm / pieces;
                const Eigen::Vector3d pointInCamera = cameraFromPatient * piece.pointInPatient;
                const std::optional<Eigen::Vector2d> pixel = project(camera, pointInCamera);
                if (dose > 1e-6 && pixel) {
                    const double radiusPx = piece.radiusMm / millimetersPerPixel(camera, pointInCamera.z());
                    splatDisc(thicknessMm, *pixel, radiusPx, dose);
                }
            }
        }
    }
    return thicknessMm;
}

}   // namespace angiopose::core
