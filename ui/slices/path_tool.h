#pragma once

#include "ui/slices/slice_tool.h"

#include <optional>
#include <vector>

namespace angiopose::ui {

/// Two clicks in the slices, from and to, for the one vessel between them; meanwhile the way to the mouse is shown. The
/// ends may lie in different slices and planes.
class PathTool : public SliceTool {
    Q_OBJECT
public:
    explicit PathTool(SliceModel& model);

    void showWay(std::vector<Eigen::Vector3d> pointsInPatient);   ///< to where the mouse was when it was wished for

    QString caption() const override;
    void end() override { drop(); }
    bool click(const SlicePointer& pointer) override;
    void hover(const SlicePointer& pointer) override;
    void leave() override;
    bool takeBack() override;
    void paint(QPainter& painter, SliceView& view) const override;

signals:
    void pathRequested(const Eigen::Vector3d& fromInPatient, const Eigen::Vector3d& toInPatient);   ///< to be shown
    void chosen(const Eigen::Vector3d& fromInPatient, const Eigen::Vector3d& toInPatient);
    void begun();   ///< the first click, or none any longer: ways of before mean nothing

private:
    void drop();

    std::optional<Eigen::Vector3d> from_;
    std::vector<Eigen::Vector3d> way_;
};

}   // namespace angiopose::ui
