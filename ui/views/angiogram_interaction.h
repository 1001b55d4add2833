#pragma once

#include "ui/views/angiogram_annotations.h"
#include "ui/views/angiogram_view.h"
#include "ui/views/image_tool.h"
#include "ui/views/image_viewport.h"

#include <QPointF>
#include <QPointer>

namespace angiopose::ui {

/// State that an angiogram view keeps between events.
struct AngiogramView::Interaction {
    ImageRole role = ImageRole::Working;
    ImageViewport viewport;
    AngiogramAnnotations annotations;
    bool hasFrame = false;
    std::pair<int, int> frame{0, 0};   ///< index of the frame, and number of frames
    Cutout cutout;   ///< cutout at its current position
    QImage excludedArea;   ///< hatching over excluded pixels, at frame resolution; null if none
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
    DragAction dragAction = DragAction::None;   // action of the current drag unless the tool handles it
    bool isDragging = false;
    bool isToolDragging = false;   // true if the tool handles the current drag
    bool isCancelled = false;   // true if the drag was canceled, whose remaining events are ignored
    QPointF pressedAt;
    Qt::KeyboardModifiers pressedWith;
    QPointF lastAt;
    std::optional<int> hovered;
    double wheelSteps = 0.0;   // fractions of a frame accumulated from touch pads and drags

    ToolPoint toolPoint(const QPointF& position, Qt::KeyboardModifiers modifiers) const;
    double mmPerImagePx() const;   ///< scale at the pivot; 0 if unknown
};

}   // namespace angiopose::ui
