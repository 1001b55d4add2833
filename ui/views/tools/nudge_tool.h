#pragma once

#include "core/geometry/pose_offset.h"
#include "ui/views/image_tool.h"
#include "ui/views/tools/nudge_drag.h"
#include "ui/words/pose_axis.h"

namespace angiopose::ui {

/// Tool that moves the tree on the image: a drag shifts the tree, rolls it on the ring, tilts it on the arcs, and
/// changes its depth on the slider; keys move the tree in steps.
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
    StrokeMesh strokes(int heightPx) const override;
    void paint(QPainter& painter) const override;

signals:
    void dragStarted();
    void dragged(const core::PoseOffset& offsetSinceStart);   ///< zero except for the active handle
    void dragFinished();
    void dragCancelled();
    void keyNudged(const ui::Nudge& nudge);

private:
    NudgeGrip grip() const;   ///< handles around the pivot of the tree
    PoseHandleState handleState() const;
    QString offsetText() const;

    std::optional<NudgeDrag> nudge_;
    core::PoseOffset dragged_;   ///< offset of the current drag
    PoseHandle hoveredHandle_ = PoseHandle::None;
    double hoveredAngleRad_ = 0.0;
};

}   // namespace angiopose::ui
