#pragma once

#include "core/vessel/vessel_tree.h"
#include "ui/views/image_tool.h"

#include <memory>
#include <vector>

namespace angiopose::ui {

/// Tool that picks the rotation center on the vessels: by a click on the projected tree, or with Enter after the arrow
/// keys, which move from one bifurcation to the next. Delete resets the center to the centroid.
class PivotTool : public ImageTool {
    Q_OBJECT
public:
    using ImageTool::ImageTool;

    void showTree(const core::VesselTree& tree);   ///< sets the tree on which the center is picked

    QString caption() const override;
    const Color& tone() const override;
    void end() override;
    bool click(const ToolPoint& point) override;
    void hover(const ToolPoint& point) override;
    void leave() override;
    bool takesKey(const QKeyEvent& event) const override;
    void keyPress(const QKeyEvent& event) override;
    bool picksBranches() const override { return false; }
    std::optional<QCursor> cursor(bool isDragging) const override;
    void paint(QPainter& painter) const override;

signals:
    void picked(const Eigen::Vector3d& pointInPatient);
    void centroidRequested();

private:
    std::optional<Eigen::Vector3d> pointAt(const ToolPoint& point) const;
    void step(int by);

    core::VesselTree tree_;
    std::vector<Eigen::Vector3d> nodes_;   ///< bifurcations and ends, through which the arrow keys step
    std::optional<Eigen::Vector3d> candidate_;   ///< point that the next click or Enter picks
    std::size_t node_ = 0;   ///< index into `nodes_` selected with the arrow keys
};

}   // namespace angiopose::ui
