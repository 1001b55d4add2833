#include "ui/scenes/orientation_marker.h"

#include <algorithm>
#include <array>

namespace angiopose::ui {
namespace {

// Sizes in px at pixel scale 1.
constexpr double armPx = 19.0;
constexpr double marginPx = 40.0;
constexpr double letterSpacePx = 11.0;   // minimum distance between the centers of two letters

struct PatientAxis {
    char letter;
    Eigen::Vector3d direction;
};

// Axes in LPS: +x left, +y posterior, +z superior (head).
const std::array<PatientAxis, 3> patientAxes{{{'L', {1, 0, 0}}, {'P', {0, 1, 0}}, {'H', {0, 0, 1}}}};

bool isTowardsViewer(const Eigen::Vector3d& onScreen)
{
    return onScreen.z() > -0.05;
}

}   // namespace

Eigen::Vector2d OrientationMarker::center() const
{
    return {widthPx - marginPx * pixelScale, marginPx * pixelScale};
}

void addOrientationMarker(StrokeMesh& mesh, const OrientationMarker& sign, const Palette& colors)
{
    for (const PatientAxis& axis : patientAxes) {
        const Eigen::Vector3d onScreen = sign.toScreen.rotate(axis.direction);
        const Eigen::Vector2d tip = sign.center() + armPx * sign.pixelScale * onScreen.head<2>();
        const Color tone = mixed(colors.field, colors.label, isTowardsViewer(onScreen) ? 0.9 : 0.45);
        addLine(mesh, {{sign.center(), tone}, {tip, tone}}, {1.4 * sign.pixelScale});
    }
}

std::vector<OrientationLetter> markerLetters(const OrientationMarker& sign)
{
    std::vector<OrientationLetter> letters;
    for (const PatientAxis& axis : patientAxes) {
        const Eigen::Vector3d onScreen = sign.toScreen.rotate(axis.direction);
        if (onScreen.head<2>().norm() <= 0.42) {
            continue;
        }
        const Eigen::Vector2d outward = onScreen.head<2>() * armPx + onScreen.head<2>().normalized() * 9.0;
        const Eigen::Vector2d at = sign.center() + sign.pixelScale * outward;
        const bool isFree = std::ranges::all_of(letters, [&](const OrientationLetter& other) {
            return (other.at - at).norm() > letterSpacePx * sign.pixelScale;
        });
        if (isFree) {
            letters.push_back({axis.letter, at, isTowardsViewer(onScreen)});
        }
    }
    return letters;
}

}   // namespace angiopose::ui
