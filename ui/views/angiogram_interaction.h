#pragma once

#include "ui/views/angiogram_annotations.h"
#include "ui/views/angiogram_view.h"
#include "ui/views/image_tool.h"
#include "ui/views/image_viewport.h"

#include <QPointF>
#include <QPointer>

namespace angiopose::ui {

/// What an angiogram view remembers between events.
struct AngiogramView::Interaction {
    ImageRole role = ImageRole::Working;
    ImageViewport viewport;
    AngiogramAnnotations annotations;
    bool hasFrame = false;
    std::pair<int, int> frame{0, 0};   ///< index and count
    Cutout cutout;   ///< as it is drawn
    QImage keptOut;   ///< over the frame, one pixel for each of its; null: nothing
    bool isOrientationKnown = false;
    std::pair<int, int> frameSize{0, 0};
    core::ProjectionCamera camera;
    core::RigidTransform cameraFromPatient;
    Eigen::Vector3d pivotInPatient = Eigen::Vector3d::Zero();
    std::optional<Eigen::Vector3d> pickedPivot;
    double lineWidth = 2.4;
    ImageCrosshair crosshair;
    std::vector<ImageMark> marks;   ///< measured
    std::vector<ImageMark> placedMarks;
    QString absence;

    QPointer<ImageTool> tool;
    MousePreset mouse;
    Qt::MouseButton pressed = Qt::NoButton;
    DragAction dragAction = DragAction::None;   // of the drag under way, unless it is the tool's
    bool isDragging = false;
    bool isToolDragging = false;   // the drag under way is the tool's
    bool isCancelled = false;   // the rest of a cancelled drag does nothing
    QPointF pressedAt;
    Qt::KeyboardModifiers pressedWith;
    QPointF lastAt;
    std::optional<int> hovered;
    double wheelSteps = 0.0;   // fine steps of touch pads and drags add up to whole frames

    ToolPoint toolPoint(const QPointF& position, Qt::KeyboardModifiers modifiers) const;
    double mmPerImagePx() const;   ///< at the pivot; 0 when unknown
};

}   // namespace angiopose::ui