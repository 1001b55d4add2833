#include "app/showing/pose_preview.h"

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

}   // namespace angiopose::app
