#pragma once

#include "ui/slices/slice_tool.h"

#include <optional>
#include <vector>

namespace angiopose::ui {

/// Traces one vessel between two clicks in the slices, with a preview of the path to the pointer. The end points may
/// lie in different slices and planes.
class PathTool : public SliceTool {
    Q_OBJECT
public:
    explicit PathTool(SliceModel& model);

    void showPath(std::vector<Eigen::Vector3d> pointsInPatient);   ///< path to the pointer position of the request

    QString caption() const override;
    void end() override { drop(); }
    bool click(const SlicePointer& pointer) override;
    void hover(const SlicePointer& pointer) override;
    void leave() override;
    bool undoStep() override;
    void paint(QPainter& painter, SliceView& view) const override;

signals:
    void pathRequested(const Eigen::Vector3d& fromInPatient, const Eigen::Vector3d& toInPatient);   ///< for the preview
    void endsPicked(const Eigen::Vector3d& fromInPatient, const Eigen::Vector3d& toInPatient);
    void pathReset();   ///< emitted when the first point is set or removed, which makes earlier paths obsolete

private:
    void drop();

    std::optional<Eigen::Vector3d> from_;
    std::vector<Eigen::Vector3d> path_;
};

}   // namespace angiopose::ui
