#include "core/geometry/pose_axis.h"

#include <algorithm>

namespace angiopose::core {
namespace {

constexpr std::array<std::string_view, poseAxes.size()> ids{"right", "up", "along-ray", "roll", "lao-rao", "cra-cau"};

}   // namespace

bool isAnyLocked(const PoseLocks& locks)
{
    return std::find(locks.begin(), locks.end(), true) != locks.end();
}

double& valueOf(PoseOffset& offset, PoseAxis axis)
{
    switch (axis) {
        case PoseAxis::Right:
            return offset.rightMm;
        case PoseAxis::Up:
            return offset.upMm;
        case PoseAxis::AlongRay:
            return offset.alongRayMm;
        case PoseAxis::Roll:
            return offset.rollDeg;
        case PoseAxis::LaoRao:
            return offset.laoRaoDeg;
        case PoseAxis::CraCau:
            break;
    }
    return offset.craCauDeg;
}

double valueOf(const PoseOffset& offset, PoseAxis axis)
{
    PoseOffset copy = offset;
    return valueOf(copy, axis);
}

std::string_view idOf(PoseAxis axis)
{
    return ids[static_cast<std::size_t>(axis)];
}

std::optional<PoseAxis> parsePoseAxis(std::string_view id)
{
    const auto found = std::find(ids.begin(), ids.end(), id);
    return found == ids.end() ? std::nullopt : std::optional(poseAxes[static_cast<std::size_t>(found - ids.begin())]);
}

std::string poseAxisIds()
{
    std::string text;
    for (const std::string_view id : ids) {
        text += (text.empty() ? "" : ", ") + std::string(id);
    }
    return text;
}

}   // namespace angiopose::core
