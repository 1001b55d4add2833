#pragma once

#include "ui/views/angiogram_annotations.h"
#include "ui/views/angiogram_view.h"
#include "ui/views/image_viewport.h"
#include "ui/views/nudge_drag.h"

#include <QPointF>

namespace ui {

/// What an angiogram view remembers between events.
struct AngiogramView::Interaction {
    ImageViewport viewport;
    AngiogramAnnotations annotations;
    bool hasFrame = false;
    bool isOrientationKnown = false;
    std::pair<int, int> frameSize{0, 0};
    core::ProjectionCamera camera;
    core::RigidTransform cameraFromPatient;
    Eigen::Vector3d pivotInPatient = Eigen::Vector3d::Zero();
    double lineWidth = 2.4;

    Qt::MouseButton pressed = Qt::NoButton;
    bool isDragging = false;
    bool isCancelled = false;   // the rest of a cancelled drag does nothing
    QPointF pressedAt;
    QPointF lastAt;
    std::optional<NudgeDrag> nudge;
    PoseHandle hotHandle = PoseHandle::None;
    double hotAngleRad = 0.0;
    std::optional<int> hovered;
    double wheelSteps = 0.0;   // fine steps of touch pads add up to whole frames

    NudgeGrip grip(const QSizeF& widgetSize) const;   ///< of the tree's pivot
    double mmPerImagePx() const;   ///< at the pivot; 0 when unknown
};

}   // namespace ui
