#pragma once

#include "core/viewing/angle_map.h"

#include <QWidget>

#include <optional>

namespace angiopose::ui {

/// Map of the visibility of a vessel segment at each pair of gantry angles: RAO to LAO horizontally, CAU to CRA upward,
/// colored with the residual color ramp from well visible to hidden. A click or the arrow keys select angles.
class AngleMapPlot : public QWidget {
    Q_OBJECT
public:
    explicit AngleMapPlot(QWidget* parent = nullptr);

    void showMap(const std::optional<core::AngleMap>& map);
    void showCurrent(const std::optional<core::GantryAngles>& angles);   ///< marks the current gantry angles
    void showPicked(const core::GantryAngles& angles);
    QSize sizeHint() const override { return {440, 230}; }

signals:
    void picked(const core::GantryAngles& angles);

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    QRectF area() const;
    QPointF positionOf(const core::GantryAngles& angles) const;
    core::GantryAngles anglesAt(const QPointF& pos) const;   ///< returns the nearest angles inside the map
    void paintAxes(QPainter& painter) const;
    void paintMarks(QPainter& painter) const;

    std::optional<core::AngleMap> map_;
    std::optional<core::GantryAngles> current_;
    core::GantryAngles picked_;
};

}   // namespace angiopose::ui
