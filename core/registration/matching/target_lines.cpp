#include "core/registration/matching/target_lines.h"

namespace angiopose::core {

TargetLines::TargetLines(const TargetSamples& target, const ProjectionCamera& camera)
    : map_(target.points, camera.width, camera.height)
{
    lines_.reserve(target.size());
    for (std::size_t i = 0; i < target.size(); ++i) {
        const bool hasPrevious = i > 0 && target.curveIndex[i - 1] == target.curveIndex[i];
        const bool hasNext = i + 1 < target.size() && target.curveIndex[i + 1] == target.curveIndex[i];
        lines_.push_back({target.points[i].x(), target.points[i].y(), target.tangents[i].x(), target.tangents[i].y(),
                          hasPrevious, hasNext});
    }
}

}   // namespace angiopose::core
