#pragma once

#include "core/geometry/landmark.h"
#include "ui/views/image_tool.h"

#include <vector>

namespace angiopose::ui {

/// Landmarks as displayed: the complete pairs and at most one incomplete pair.
struct LandmarkMarks {
    std::vector<core::Landmark> pairs;
    std::optional<Eigen::Vector3d> pendingPointInPatient;
    std::optional<Eigen::Vector2d> pendingPixel;
    std::vector<Eigen::Vector3d> nodesInPatient;   ///< bifurcations and ends of the tree, which can be dragged
};

/// Picks landmark pairs between the vessels and the image. A click sets the pixel of a pair; a drag moves it, or drags
/// a node of the projected tree to its true position. Enter requests the pose, Delete removes the last pair.
class LandmarkTool : public ImageTool {
    Q_OBJECT
public:
    using ImageTool::ImageTool;

    void showMarks(const LandmarkMarks& marks);

    QString caption() const override;
    bool startDrag(const ToolPoint& pressed) override;
    void drag(const ToolPoint& point) override;
    void finishDrag(const ToolPoint& point) override;
    void cancelDrag() override;
    bool click(const ToolPoint& point) override;
    bool takesKey(const QKeyEvent& event) const override;
    void keyPress(const QKeyEvent& event) override;
    bool undoStep() override;
    void end() override;
    bool picksBranches() const override { return false; }
    std::optional<QCursor> cursor(bool isDragging) const override;
    void paint(QPainter& painter) const override;

signals:
    void pixelPicked(const Eigen::Vector2d& pixel);
    void pairDrawn(const Eigen::Vector3d& pointInPatient, const Eigen::Vector2d& pixel);
    void pairMoved(int index, const Eigen::Vector2d& pixel);
    void removeLastRequested();
    void cancelRequested();
    void poseRequested();

private:
    /// Dragged item: the pixel of a pair, or the node of a new pair.
    struct DraggedItem {
        std::optional<int> index;
        Eigen::Vector3d nodeInPatient = Eigen::Vector3d::Zero();
        Eigen::Vector2d pixel = Eigen::Vector2d::Zero();
    };
    std::optional<DraggedItem> draggableAt(const QPointF& position) const;
    void paintPair(QPainter& painter, const QString& label, const std::optional<Eigen::Vector2d>& pixel,
                   const std::optional<Eigen::Vector3d>& pointInPatient) const;

    LandmarkMarks marks_;
    std::optional<DraggedItem> dragged_;
};

}   // namespace angiopose::ui
