#include "ui/views/image_sides.h"

#include <array>
#include <cmath>
#include <utility>

namespace angiopose::ui {
namespace {

std::string lettersOf(const Eigen::Vector3d& directionInPatient)
{
    constexpr double askew = 0.45;   // minimum direction cosine for a second letter
    const std::array<std::pair<double, char>, 3> parts{
        {{std::abs(directionInPatient.x()), directionInPatient.x() > 0.0 ? 'L' : 'R'},
         {std::abs(directionInPatient.y()), directionInPatient.y() > 0.0 ? 'P' : 'A'},
         {std::abs(directionInPatient.z()), directionInPatient.z() > 0.0 ? 'H' : 'F'}}};
    std::size_t first = 0;
    for (std::size_t i = 1; i < parts.size(); ++i) {
        first = parts[i].first > parts[first].first ? i : first;
    }
    std::string letters(1, parts[first].second);
    std::size_t second = first == 0 ? 1 : 0;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        second = i != first && parts[i].first > parts[second].first ? i : second;
    }
    if (parts[second].first > askew) {
        letters += parts[second].second;
    }
    return letters;
}

}   // namespace

ImageSides imageSides(const core::ProjectionCamera& camera, const core::RigidTransform& cameraFromPatient)
{
    const Eigen::Matrix3d patientFromCamera = cameraFromPatient.rotation.transpose();
    const Eigen::Vector3d right = std::copysign(1.0, camera.fx) * patientFromCamera.col(0);
    const Eigen::Vector3d down = std::copysign(1.0, camera.fy) * patientFromCamera.col(1);
    return {lettersOf(-right), lettersOf(right), lettersOf(-down), lettersOf(down)};
}

}   // namespace angiopose::ui
