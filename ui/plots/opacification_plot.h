#pragma once

#include "ui/plots/frame_bars.h"

namespace angiopose::ui {

/// Large plot of the opacification curve of a run: marks the mask frames and the peak-opacification frame, and shows
/// frame and time under the pointer. A click or ← → selects a frame.
class OpacificationPlot : public QWidget {
    Q_OBJECT
public:
    explicit OpacificationPlot(QWidget* parent = nullptr);

    void showFrames(const FrameCurve& curve);
    void showMasks(const std::vector<int>& frames);
    void showCurrent(int frame);
    std::optional<int> hoveredFrame() const { return hovered_; }
    QPointF pointOf(int frame) const;   ///< returns a point of the curve in widget px
    QSize sizeHint() const override { return {720, 320}; }

signals:
    void frameRequested(int frame);

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    QRectF area() const;
    int frameAt(double x) const;
    int lastFrame() const { return static_cast<int>(curve_.opacification.size()) - 1; }
    void paintAxes(QPainter& painter) const;
    void paintCurve(QPainter& painter) const;

    FrameCurve curve_;
    std::vector<int> masks_;
    int current_ = 0;
    std::optional<int> hovered_;
};

}   // namespace angiopose::ui
