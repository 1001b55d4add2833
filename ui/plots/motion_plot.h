#pragma once

#include <QWidget>

#include <vector>

namespace angiopose::ui {

/// Displacement of the vessels in one frame relative to the registered pose.
struct FrameMotion {
    int frame = 0;
    double inPlaneMm = 0.0;
    double depthMm = 0.0;   ///< displacement in depth; positive away from the X-ray source
    double rotationDeg = 0.0;
    bool isTrustworthy = false;
};

/// Plot of the vessel motion over the frames of a run: in-plane shift as a line, frames that could not be tracked as
/// open dots. A click or ← → selects a frame.
class MotionPlot : public QWidget {
    Q_OBJECT
public:
    explicit MotionPlot(QWidget* parent = nullptr);

    void showMotion(const std::vector<FrameMotion>& motion);
    void showCurrent(int frame);
    QSize sizeHint() const override { return {240, 100}; }

signals:
    void frameRequested(int frame);

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    QRectF area() const;
    double xOf(std::size_t index) const;
    std::size_t indexAt(double x) const;
    void paintLine(QPainter& painter) const;
    void request(std::size_t index);

    std::vector<FrameMotion> motion_;
    double maxMm_ = 1.0;
    int current_ = 0;
};

}   // namespace angiopose::ui
