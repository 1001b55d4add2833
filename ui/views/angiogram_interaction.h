#pragma once

#include "ui/views/angiogram_annotations.h"
#include "ui/views/angiogram_view.h"
#include "ui/views/image_tool.h"
#include "ui/views/image_viewport.h"

#include <QPointF>
#include <QPointer>

namespace angiopose::ui {

/// State of an angiogram view between events.
struct AngiogramView::Interaction {
    ImageRole role = ImageRole::Working;
    ImageViewport viewport;
    AngiogramAnnotations annotations;
    bool hasFrame = false;
    std::pair<int, int> frame{0, 0};   ///< index and count
    Cutout cutout;   ///< as currently drawn
    QImage keptOut;   ///< hatching over the frame, one pixel per frame pixel; null: none
    bool isOrientationKnown = false;
    std::pair<int, int> frameSize{0, 0};
    core::ProjectionCamera camera;
    core::RigidTransform cameraFromPatient;
    Eigen::Vector3d pivotInPatient = Eigen::Vector3d::Zero();
    std::optional<Eigen::Vector3d> pickedPivot;
    double lineWidth = 2.4;
    ImageCrosshair crosshair;
    std::vector<ImageMark> marks;   ///< measurements
    std::vector<ImageMark> placedMarks;
    QString absence;

    QPointer<ImageTool> tool;
    MousePreset mouse;
    Qt::MouseButton pressed = Qt::NoButton;
    DragAction dragAction = DragAction::None;   // of the current drag, if not handled by the tool
    bool isDragging = false;
    bool isToolDragging = false;   // the tool handles the current drag
    bool isCancelled = false;   // ignores the rest of a canceled drag
    QPointF pressedAt;
    Qt::KeyboardModifiers pressedWith;
    QPointF lastAt;
    std::optional<int> hovered;
    double wheelSteps = 0.0;   // accumulates fractions of a frame from touch pads and drags

    ToolPoint toolPoint(const QPointF& position, Qt::KeyboardModifiers modifiers) const;
    double mmPerImagePx() const;   ///< at the pivot; 0 if unknown
};

}   // namespace angiopose::ui