#pragma once

#include "core/vessel/vessel_tree.h"
#include "ui/views/image_tool.h"

#include <memory>
#include <vector>

namespace angiopose::ui {

/// Picks the rotation center on the vessels: by a click on the projected tree, or by the arrow keys from one
/// bifurcation to the next and Enter. Delete resets it to the centroid.
class PivotTool : public ImageTool {
    Q_OBJECT
public:
    using ImageTool::ImageTool;

    void showTree(const core::VesselTree& tree);   ///< displayed tree from which to pick

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
    void centroidWanted();

private:
    std::optional<Eigen::Vector3d> placeAt(const ToolPoint& point) const;
    void step(int by);

    core::VesselTree tree_;
    std::vector<Eigen::Vector3d> nodes_;   ///< bifurcations and ends, visited by the arrow keys
    std::optional<Eigen::Vector3d> candidate_;   ///< point that a click or Enter would pick
    std::size_t node_ = 0;   ///< index selected by the arrow keys
};

}   // namespace angiopose::ui