#pragma once

#include "ui/views/image_tool.h"

#include <QPolygonF>

namespace angiopose::ui {

/// Effect of a lasso on the set of auxiliary branches.
enum class LassoEffect { Replaces, Adds, Removes };

/// Tool that selects auxiliary branches with a lasso, which replaces the set, adds to it (Shift) or removes from it
/// (Ctrl). A double-click on the background has no effect.
class LassoTool : public ImageTool {
    Q_OBJECT
public:
    using ImageTool::ImageTool;

    QString caption() const override;
    void end() override { outline_.clear(); }
    bool startDrag(const ToolPoint& pressed) override;
    void drag(const ToolPoint& point) override;
    void finishDrag(const ToolPoint& point) override;
    void cancelDrag() override;
    std::optional<QCursor> cursor(bool isDragging) const override;
    void paint(QPainter& painter) const override;

signals:
    void outlineDrawn(const QPolygonF& outlineInImagePx, ui::LassoEffect effect);

private:
    QPolygonF outline_;   ///< vertices of the lasso, image px
};

}   // namespace angiopose::ui
