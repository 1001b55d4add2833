#include "app/showing/pose_preview.h"

#include "core/case/case_views.h"

#include <utility>

namespace angiopose::app {

PosePreview::PosePreview(const CaseDocument& document, QObject* parent) : QObject(parent), document_(document) {}

void PosePreview::show(PreviewSource source, const core::RigidTransform& cameraFromPatient, ResidualColors colors)
{
    const auto before = std::exchange(source_, source);
    pose_ = cameraFromPatient;
    colors_ = colors;
    if (before && before != source) {
        emit replaced(*before);
    }
    emit changed();
}

void PosePreview::end(PreviewSource source)
{
    if (source_ != source) {
        return;
    }
    source_.reset();
    colors_ = ResidualColors::Visible;
    emit changed();
}

const core::RigidTransform& PosePreview::pose() const
{
    return source_ ? pose_ : document_.current().shown().cameraFromPatient;
}

core::RigidTransform PosePreview::poseOfView(std::size_t view) const
{
    const core::Case& current = document_.current();
    if (view == current.shownView) {
        return pose();
    }
    const core::View& other = current.views[view];
    if (!source_ || !movesAllViews_ || source_ == PreviewSource::Frame) {
        return other.cameraFromPatient;
    }
    if (source_ == PreviewSource::Start) {
        const auto start = core::initialPoseOf(other, current.vessels);
        return start ? start.value() : other.cameraFromPatient;
    }
    return core::poseAfterMotion(current, view, pose_);
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
