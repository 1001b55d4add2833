#pragma once

#include "ui/views/image_tool.h"

namespace angiopose::ui {

/// Moves the mask of a subtraction under the frame, by drags and arrow keys, until bones vanish.
class MaskShiftTool : public ImageTool {
    Q_OBJECT
public:
    using ImageTool::ImageTool;

    void showShift(const Eigen::Vector2d& shiftPx);   ///< silent
    const Eigen::Vector2d& shiftPx() const { return shift_; }

    QString caption() const override;
    const Color& tone() const override;
    void begin() override { emit begun(); }
    void end() override { emit ended(); }
    bool startDrag(const ToolPoint& pressed) override;
    void drag(const ToolPoint& point) override;
    void finishDrag(const ToolPoint&) override { emit settled(); }
    void cancelDrag() override;
    bool takesKey(const QKeyEvent& event) const override;
    void keyPress(const QKeyEvent& event) override;
    bool picksBranches() const override { return false; }
    bool hidesOverlay() const override { return true; }
    std::optional<QCursor> cursor(bool) const override { return QCursor(Qt::SizeAllCursor); }

signals:
    void begun();
    void ended();
    void shifted(const Eigen::Vector2d& shiftPx);   ///< under way
    void settled();   ///< for the moment

private:
    void moveTo(const Eigen::Vector2d& shiftPx);

    Eigen::Vector2d shift_ = Eigen::Vector2d::Zero();   ///< right, down
    Eigen::Vector2d shiftBefore_ = Eigen::Vector2d::Zero();
    Eigen::Vector2d last_ = Eigen::Vector2d::Zero();
};

}   // namespace angiopose::ui