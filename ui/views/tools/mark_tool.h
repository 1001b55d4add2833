#pragma once

#include "ui/scenes/image_mark.h"
#include "ui/views/image_tool.h"

#include <functional>
#include <vector>

class QLineEdit;

namespace angiopose::ui {

/// What a click on the image sets.
enum class MarkMode { CheckPoint, OstiumRing, SeenHere, Arrow, Words };
inline constexpr std::size_t markModeCount = 5;

/// Sets marks in the image: a click one place, in the mode Arrow a drag from its tail to its tip; a drag from a handle
/// moves what is there. Words are typed into a line at the place. Delete removes what is chosen.
class MarkTool : public ImageTool {
    Q_OBJECT
public:
    MarkTool(MarkMode mode, AngiogramView& view);

    /// Where a drag takes hold of what is there, px of the image; a drag under way ends.
    void showHandles(std::vector<Eigen::Vector2d> handles);
    /// The place that a click at a pixel would set; nothing: none. Not set: the pixel itself.
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
    bool takeBack() override;
    bool picksBranches() const override { return false; }
    std::optional<QCursor> cursor(bool isDragging) const override;
    void paint(QPainter& painter) const override;

signals:
    void placed(const Eigen::Vector2d& pixel);
    void written(const std::vector<Eigen::Vector2d>& pixels, const QString& words);   ///< an arrow may go without
    void handleMoved(int handle, const Eigen::Vector2d& pixel);
    void removeRequested();   ///< what is chosen, or the last

private:
    std::optional<std::size_t> handleAt(const QPointF& position) const;
    std::optional<Eigen::Vector2d> snapped(const Eigen::Vector2d& pixel) const;
    void askWords();
    void finishWords();
    void drop();

    MarkMode mode_;
    Snap snap_;
    std::vector<Eigen::Vector2d> handles_;
    std::optional<std::size_t> held_;
    std::vector<Eigen::Vector2d> points_;   ///< of the arrow or words under way
    std::optional<Eigen::Vector2d> mousePx_;
    QLineEdit* words_ = nullptr;   ///< while words are typed
};

}   // namespace angiopose::ui
