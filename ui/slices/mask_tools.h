#pragma once

#include "core/imaging/mask_brush.h"
#include "core/imaging/mask_cut.h"
#include "ui/slices/slice_tool.h"

#include <vector>

namespace angiopose::ui {

/// Round brush for the mask, shown as a circle of the brush size under the pointer. Ctrl swaps painting and erasing;
/// Shift+wheel, + and − change the brush size.
class MaskBrushTool : public SliceTool {
    Q_OBJECT
public:
    MaskBrushTool(core::BrushMode mode, SliceModel& model);

    void setRadiusMm(double radiusMm);
    QString caption() const override;
    void end() override;
    bool startDrag(const SlicePointer& pressed) override;
    void drag(const SlicePointer& pointer) override;
    void finishDrag(const SlicePointer& pointer) override;
    bool click(const SlicePointer& pointer) override;
    bool doubleClick(const SlicePointer& pointer) override { return click(pointer); }
    void hover(const SlicePointer& pointer) override;
    void leave() override;
    bool wheel(const SlicePointer& pointer, double steps) override;
    bool takesKey(const QKeyEvent& event) const override;
    void keyPress(const QKeyEvent& event) override;
    bool undoStep() override;
    QCursor cursor() const override { return Qt::CrossCursor; }
    void paint(QPainter& painter, SliceView& view) const override;

signals:
    void brushed(core::BrushMode mode, const core::SliceGrid& slice, const core::BrushStep& step);
    void strokeEnded();
    void radiusRequested(double radiusMm);

private:
    void brushTo(const SlicePointer& pointer);

    core::BrushMode mode_;
    core::BrushMode strokeMode_;   ///< paints or erases; fixed during a stroke
    double radiusMm_ = 2.0;
    bool isStroking_ = false;
    Eigen::Vector3d last_ = Eigen::Vector3d::Zero();
    const SliceView* hoveredView_ = nullptr;   ///< slice view under the pointer; null if there is none
    QPointF pointer_;
};

/// Scissors: removes the mask inside a lasso drawn in a slice or, with Shift, outside it.
class MaskCutTool : public SliceTool {
    Q_OBJECT
public:
    using SliceTool::SliceTool;

    QString caption() const override;
    void end() override;
    bool startDrag(const SlicePointer& pressed) override;
    void drag(const SlicePointer& pointer) override;
    void finishDrag(const SlicePointer& pointer) override;
    bool undoStep() override;
    void paint(QPainter& painter, SliceView& view) const override;

signals:
    void cut(const core::MaskCut& cut);   ///< the receiver sets the depth of the cut

private:
    const SliceView* view_ = nullptr;   ///< view in which the lasso is drawn
    std::vector<Eigen::Vector3d> outline_;
};

}   // namespace angiopose::ui
