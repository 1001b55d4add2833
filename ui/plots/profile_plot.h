#pragma once

#include "core/measuring/branch_profile.h"

#include <QWidget>

#include <optional>

namespace angiopose::ui {

/// Plot of the profile of a branch from start to end: diameter as a line over the dashed reference diameter, minimum
/// diameter as a dot, curvature as a thin line on a separate scale. The mouse or ← → highlights a position; a click
/// selects it.
class ProfilePlot : public QWidget {
    Q_OBJECT
public:
    explicit ProfilePlot(QWidget* parent = nullptr);

    void showProfile(const core::BranchProfile& profile);   ///< leaves the plot empty if the profile has no samples
    QSize sizeHint() const override { return {240, 130}; }

signals:
    void pointerMoved(
        const std::optional<Eigen::Vector3d>& pointInPatient);   ///< nullopt if the pointer has left the plot
    void positionClicked(const Eigen::Vector3d& pointInPatient);

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    using Value = double (*)(const core::ProfileSample& sample);
    QRectF area() const;
    QPointF positionOf(const core::ProfileSample& sample, double fraction) const;
    std::size_t indexAt(double x) const;
    void point(std::size_t index);
    void paintCurve(QPainter& painter, Value value, double maximum, const QPen& pen) const;
    void paintLabels(QPainter& painter) const;
    QString textAt(std::size_t index) const;

    core::BranchProfile profile_;
    double maxMm_ = 0.0;   ///< maximum of the diameter axis; 0 if diameters are unknown
    double maxCurvature_ = 0.0;
    std::optional<std::size_t> hoveredIndex_;
};

}   // namespace angiopose::ui
