#pragma once

#include "core/viewing/angle_map.h"

#include <QWidget>

#include <optional>

namespace angiopose::ui {

/// How a part of the vessels is seen from all angles of the gantry: RAO to LAO across, CAU to CRA upwards, in the
/// colours of the residuals from well seen to hidden. A click, or the arrow keys, picks angles.
class AngleMapPlot : public QWidget {
    Q_OBJECT
public:
    explicit AngleMapPlot(QWidget* parent = nullptr);

    void showMap(const std::optional<core::AngleMap>& map);
    void showNow(const std::optional<core::GantryAngles>& angles);   ///< where the gantry stands
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
    QPointF placeOf(const core::GantryAngles& angles) const;
    core::GantryAngles anglesAt(const QPointF& place) const;   ///< the nearest within the map
    void paintAxes(QPainter& painter) const;
    void paintMarks(QPainter& painter) const;

    std::optional<core::AngleMap> map_;
    std::optional<core::GantryAngles> now_;
    core::GantryAngles picked_;
};

}   // namespace angiopose::ui
