#pragma once

#include "core/vessel/vessel_tree.h"
#include "ui/views/image_tool.h"

#include <memory>
#include <vector>

namespace angiopose::ui {

/// Picks the place on the vessels that they turn about: a click on the projected tree, or the arrows from one
/// bifurcation to the next and Enter. Delete asks for the centroid again.
class PivotTool : public ImageTool {
    Q_OBJECT
public:
    using ImageTool::ImageTool;

    void showTree(const core::VesselTree& tree);   ///< that is drawn, and can be picked from

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
    std::vector<Eigen::Vector3d> nodes_;   ///< bifurcations and ends: what the arrows go through
    std::optional<Eigen::Vector3d> candidate_;   ///< what a click or Enter would take
    std::size_t node_ = 0;   ///< the arrows' place among the nodes
};

}   // namespace angiopose::ui