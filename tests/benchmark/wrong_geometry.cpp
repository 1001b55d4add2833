#include "tests/benchmark/wrong_geometry.h"

#include <cmath>

namespace angiopose::benchmarks {
namespace {

constexpr double distanceShare = 0.05;
constexpr double spacingShare = 0.03;
constexpr double principalPx = 20.0;

template <class Move>
void moveTarget(core::RegistrationInput& input, const Move& move)
{
    for (core::Curve2d& curve : input.target.curves) {
        for (Eigen::Vector2d& point : curve.pointsPx) {
            point = move(point);
        }
    }
}

void scaleFocalLength(core::RegistrationInput& input, double factor)
{
    input.camera.fx *= factor;
    input.camera.fy *= factor;
}

}   // namespace

bool hasTruth(GeometryError error)
{
    return error != GeometryError::MirroredLeftRight && error != GeometryError::MirroredUpDown &&
           error != GeometryError::Turned && error != GeometryError::UpsideDown;
}

void spoil(core::RegistrationInput& input, GeometryError error, std::uint64_t trial)
{
    const double sign = trial % 2 == 0 ? 1.0 : -1.0;
    const double right = input.camera.width - 1.0, low = input.camera.height - 1.0;
    const double heading = 2.399963 * static_cast<double>(trial);
    switch (error) {
        case GeometryError::None:
            break;
        case GeometryError::Distance:
            scaleFocalLength(input, 1.0 + sign * distanceShare);
            break;
        case GeometryError::Spacing:
            scaleFocalLength(input, 1.0 / (1.0 + sign * spacingShare));
            break;
        case GeometryError::PrincipalPoint:
            input.camera.cx += principalPx * std::cos(heading);
            input.camera.cy += principalPx * std::sin(heading);
            break;
        case GeometryError::MirroredLeftRight:
            moveTarget(input, [&](const Eigen::Vector2d& at) { return Eigen::Vector2d(right - at.x(), at.y()); });
            break;
        case GeometryError::MirroredUpDown:
            moveTarget(input, [&](const Eigen::Vector2d& at) { return Eigen::Vector2d(at.x(), low - at.y()); });
            break;
        case GeometryError::Turned:
            moveTarget(input, [&](const Eigen::Vector2d& at) {
                return sign > 0.0 ? Eigen::Vector2d(low - at.y(), at.x()) : Eigen::Vector2d(at.y(), right - at.x());
            });
            break;
        case GeometryError::UpsideDown:
            moveTarget(input, [&](const Eigen::Vector2d& at) { return Eigen::Vector2d(right - at.x(), low - at.y()); });
            break;
    }
}

core::CameraUncertainty spreadOfHeader(const core::ProjectionCamera& camera)
{
    core::CArm cArm;
    cArm.sourceToDetectorMm.origin = core::Origin::Header;
    cArm.columnSpacingMm.origin = core::Origin::Header;
    return core::uncertaintyByOrigin(cArm, camera);
}

}   // namespace angiopose::benchmarks
