#pragma once

#include "ui/views/image_tool.h"

namespace angiopose::ui {

/// Pixel shift: moves the subtraction mask relative to the frame, by drags and arrow keys, until bone cancels out.
class MaskShiftTool : public ImageTool {
    Q_OBJECT
public:
    using ImageTool::ImageTool;

    void showShift(const Eigen::Vector2d& shiftPx);   ///< emits no signal
    const Eigen::Vector2d& shiftPx() const { return shift_; }

    QString caption() const override;
    const Color& tone() const override;
    void begin() override { emit activated(); }
    void end() override { emit ended(); }
    bool startDrag(const ToolPoint& pressed) override;
    void drag(const ToolPoint& point) override;
    void finishDrag(const ToolPoint&) override { emit shiftFinished(); }
    void cancelDrag() override;
    bool takesKey(const QKeyEvent& event) const override;
    void keyPress(const QKeyEvent& event) override;
    bool picksBranches() const override { return false; }
    bool hidesOverlay() const override { return true; }
    std::optional<QCursor> cursor(bool) const override { return QCursor(Qt::SizeAllCursor); }

signals:
    void activated();
    void ended();
    void shifted(const Eigen::Vector2d& shiftPx);   ///< emitted continuously while the mask moves
    void shiftFinished();   ///< emitted at the end of a drag or key step

private:
    void moveTo(const Eigen::Vector2d& shiftPx);

    Eigen::Vector2d shift_ = Eigen::Vector2d::Zero();   ///< shift in px, positive to the right and down
    Eigen::Vector2d shiftBefore_ = Eigen::Vector2d::Zero();
    Eigen::Vector2d last_ = Eigen::Vector2d::Zero();
};

}   // namespace angiopose::ui
