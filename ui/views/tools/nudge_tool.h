#pragma once

#include "core/geometry/pose_offset.h"
#include "ui/pose_axis.h"
#include "ui/views/tools/image_tool.h"
#include "ui/views/tools/nudge_drag.h"

namespace ui {

/// Moves the tree on the image: inside the ring drags shift, on the ring they roll; keys move by steps.
class NudgeTool : public ImageTool {
    Q_OBJECT
public:
    using ImageTool::ImageTool;

    QString caption() const override;
    const Color& tone() const override;
    void end() override;
    bool startDrag(const ToolPoint& pressed) override;
    void drag(const ToolPoint& point) override;
    void finishDrag(const ToolPoint& point) override;
    void cancelDrag() override;
    void hover(const ToolPoint& point) override;
    void leave() override;
    bool takesKey(const QKeyEvent& event) const override;
    void keyPress(const QKeyEvent& event) override;
    std::optional<QCursor> cursor(bool isDragging) const override;
    void drawStrokes(Canvas canvas) const override;

signals:
    void dragStarted();
    void dragged(const core::PoseOffset& offsetSinceStart);   ///< right/up mm at the pivot's depth, or roll
    void dragFinished();
    void dragCancelled();
    void keyNudged(const ui::Nudge& nudge);

private:
    NudgeGrip grip() const;   ///< of the tree's pivot
    PoseHandleLook look() const;

    std::optional<NudgeDrag> nudge_;
    PoseHandle hotHandle_ = PoseHandle::None;
    double hotAngleRad_ = 0.0;
};

}   // namespace ui
