#pragma once

#include "ui/views/image_tool.h"

#include <QPolygonF>

namespace angiopose::ui {

/// What the branches inside a lasso become.
enum class LassoEffect { Replaces, Adds, Removes };

/// Draws a lasso around the branches that shall be auxiliary: alone, more of them (Shift) or fewer (Ctrl). A double
/// click on nothing changes nothing.
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
    void enclosed(const QPolygonF& outlineInImagePx, ui::LassoEffect effect);

private:
    QPolygonF outline_;   ///< image px
};

}   // namespace angiopose::ui