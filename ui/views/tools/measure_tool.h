#pragma once

#include "core/geometry/image_measurement.h"
#include "ui/scenes/image_mark.h"
#include "ui/views/image_tool.h"

#include <functional>
#include <vector>

namespace angiopose::ui {

/// Tool that measures in the image. Clicks set points: two for a length, three for an angle (vertex in the middle); a
/// click on the first point, a double-click or Enter closes an area. A drag draws a whole length or moves an existing
/// point. Backspace removes the last point; Delete removes the selected measurement.
class MeasureTool : public ImageTool {
    Q_OBJECT
public:
    MeasureTool(core::MeasurementKind kind, AngiogramView& view);

    /// Sets the measurements whose points can be dragged; hidden measurements have no points. Cancels the current drag.
    void showMeasurements(const std::vector<core::ImageMeasurement>& measurements);
    /// Sets the function that labels a measurement being drawn.
    void setLabelFunction(std::function<QString(const std::vector<Eigen::Vector2d>& pixels)> label);

    core::MeasurementKind kind() const { return kind_; }
    QString caption() const override;
    void end() override { drop(); }
    bool startDrag(const ToolPoint& pressed) override;
    void drag(const ToolPoint& point) override;
    void finishDrag(const ToolPoint& point) override;
    void cancelDrag() override;
    bool click(const ToolPoint& point) override;
    bool doubleClick(const ToolPoint& point) override;
    void hover(const ToolPoint& point) override;
    void leave() override;
    bool takesKey(const QKeyEvent& event) const override;
    void keyPress(const QKeyEvent& event) override;
    bool undoStep() override;
    bool picksBranches() const override { return false; }
    std::optional<QCursor> cursor(bool isDragging) const override;
    StrokeMesh strokes(int heightPx) const override;
    void paint(QPainter& painter) const override;

signals:
    void drawn(const std::vector<Eigen::Vector2d>& pixels);
    void pointMoved(int measurement, int point, const Eigen::Vector2d& pixel);
    void removeRequested();   ///< requests removal of the selected measurement or, without a selection, of the last one

private:
    struct DraggedPoint {
        std::size_t measurement = 0;
        std::size_t point = 0;
        Eigen::Vector2d pixel = Eigen::Vector2d::Zero();
    };
    std::optional<DraggedPoint> draggableAt(const QPointF& position) const;
    bool isAtFirst(const QPointF& position) const;
    void finish();
    void drop();
    std::vector<Eigen::Vector2d> currentPoints() const;   ///< points set so far plus the pointer position
    std::vector<ImageMark> marksInProgress() const;   ///< measurement being drawn or moved, with its label
    Eigen::Vector2d positionOf(const Eigen::Vector2d& pixel) const;

    core::MeasurementKind kind_;
    std::function<QString(const std::vector<Eigen::Vector2d>&)> labelFunction_;
    std::vector<core::ImageMeasurement> measurements_;
    std::vector<Eigen::Vector2d> points_;   ///< points of the measurement being drawn
    std::optional<Eigen::Vector2d> mousePx_;
    std::optional<DraggedPoint> dragged_;
    bool isDrawing_ = false;   ///< true while a length is being drawn by dragging
};

}   // namespace angiopose::ui
