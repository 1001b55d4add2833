#include "app/showing/pose_preview.h"

#include "core/case/case_views.h"

#include <utility>

namespace angiopose::app {

PosePreview::PosePreview(const CaseDocument& document, QObject* parent) : QObject(parent), document_(document) {}

void PosePreview::show(PreviewOf whose, const core::RigidTransform& cameraFromPatient, ResidualColors colors)
{
    const auto before = std::exchange(shown_, whose);
    pose_ = cameraFromPatient;
    colors_ = colors;
    if (before && before != whose) {
        emit gaveWay(*before);
    }
    emit changed();
}

void PosePreview::end(PreviewOf whose)
{
    if (shown_ != whose) {
        return;
    }
    shown_.reset();
    colors_ = ResidualColors::Kept;
    emit changed();
}

const core::RigidTransform& PosePreview::pose() const
{
    return shown_ ? pose_ : document_.current().shown().cameraFromPatient;
}

core::RigidTransform PosePreview::poseIn(std::size_t view) const
{
    const core::Case& current = document_.current();
    if (view == current.shownView) {
        return pose();
    }
    const core::View& other = current.views[view];
    if (!shown_ || !movesAllViews_ || shown_ == PreviewOf::Frame) {
        return other.cameraFromPatient;
    }
    if (shown_ == PreviewOf::Start) {
        const auto start = core::initialPoseOf(other, current.vessels);
        return start ? start.value() : other.cameraFromPatient;
    }
    return core::poseMovedAlong(current, view, pose_);
}

void PosePreview::setShape(VesselShape shape)
{
    if (std::exchange(shape_, shape) != shape) {
        emit changed();
    }
}

void PosePreview::setMotionColored(bool colored)
{
    if (std::exchange(isMotionColored_, colored) != colored) {
        emit changed();
    }
}

void PosePreview::setMovesAllViews(bool all)
{
    if (std::exchange(movesAllViews_, all) != all) {
        emit changed();
    }
}

}   // namespace angiopose::app
