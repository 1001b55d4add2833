#pragma once

#include "ui/scenes/image_mark.h"
#include "ui/views/image_tool.h"

#include <functional>
#include <vector>

class QLineEdit;

namespace angiopose::ui {

/// Type of mark that a click on the image sets.
enum class MarkMode { TargetPoint, OstiumRing, TargetInImage, Arrow, Text };
inline constexpr std::size_t markModeCount = 5;

/// Sets marks in the image: a click sets a point; in the mode Arrow, a drag goes from tail to tip; dragging a handle
/// moves an existing mark. Text is typed in a line edit at the point. Delete removes the selection.
class MarkTool : public ImageTool {
    Q_OBJECT
public:
    MarkTool(MarkMode mode, AngiogramView& view);

    /// Sets the drag handles of existing marks, image px; cancels the current drag.
    void showHandles(std::vector<Eigen::Vector2d> handles);
    /// Maps a clicked pixel to the position to set, or nullopt if there is none. If not set, the pixel itself is used.
    using Snap = std::function<std::optional<Eigen::Vector2d>(const Eigen::Vector2d& pixel)>;
    void setSnap(Snap snap) { snap_ = std::move(snap); }

    QString caption() const override;
    void end() override { drop(); }
    bool startDrag(const ToolPoint& pressed) override;
    void drag(const ToolPoint& point) override;
    void finishDrag(const ToolPoint& point) override;
    void cancelDrag() override { drop(); }
    bool click(const ToolPoint& point) override;
    void hover(const ToolPoint& point) override;
    void leave() override;
    bool takesKey(const QKeyEvent& event) const override;
    void keyPress(const QKeyEvent& event) override;
    bool undoStep() override;
    bool picksBranches() const override { return false; }
    std::optional<QCursor> cursor(bool isDragging) const override;
    void paint(QPainter& painter) const override;

signals:
    void placed(const Eigen::Vector2d& pixel);
    void written(const std::vector<Eigen::Vector2d>& pixels, const QString& words);   ///< text may be empty for arrows
    void handleMoved(int handle, const Eigen::Vector2d& pixel);
    void removeRequested();   ///< requests removal of the selected mark or, without a selection, of the last one

private:
    std::optional<std::size_t> handleAt(const QPointF& position) const;
    std::optional<Eigen::Vector2d> snapped(const Eigen::Vector2d& pixel) const;
    void startTextEdit();
    void finishTextEdit();
    void drop();

    MarkMode mode_;
    Snap snap_;
    std::vector<Eigen::Vector2d> handles_;
    std::optional<std::size_t> draggedHandle_;
    std::vector<Eigen::Vector2d> points_;   ///< points of the arrow or text annotation being drawn
    std::optional<Eigen::Vector2d> mousePx_;
    QLineEdit* textEdit_ = nullptr;   ///< line edit while the user types text; otherwise null
};

}   // namespace angiopose::ui
