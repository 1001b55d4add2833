#pragma once

#include "core/viewing/cine_clock.h"

#include <QWidget>

#include <optional>
#include <utility>
#include <vector>

namespace angiopose::ui {

/// Opacification and timing of the frames of a run.
struct FrameCurve {
    std::vector<double> opacification;   ///< opacification of each frame, 0…1
    int suggested = 0;
    double frameTimeMs = 0.0;   ///< time between frames, ms; 0 if unknown
    std::vector<int> rWaves = {};   ///< indices of the frames at ECG R waves
};

/// Describes a frame, e.g. "Frame 5 · 0.33 s · 80 % · mask": time, opacification and role.
QString describeFrame(const FrameCurve& curve, const std::vector<int>& masks, int frame);

/// Frames of a run as opacification bars; a click or ← → selects a frame. Shift marks mask frames, by dragging or with
/// ← → from the current frame. The lane above the bars shows the playback range, whose ends can be dragged.
class FrameBars : public QWidget {
    Q_OBJECT
public:
    explicit FrameBars(QWidget* parent = nullptr);

    void showFrames(const FrameCurve& curve);
    void showMasks(const std::vector<int>& frames, bool inUse);
    void showCurrent(int frame);
    void showLoop(const core::FrameRange& range);
    QSize sizeHint() const override { return {400, 40}; }

signals:
    void frameRequested(int frame);
    void maskRangeMarked(int first, int last);
    void loopMarked(const angiopose::core::FrameRange& range);   ///< emitted continuously while dragging
    void plotRequested();   ///< emitted on a double-click, to open the large plot

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    enum class LoopEnd { First, Last };
    QRectF cellOf(int frame) const;
    void paintCell(QPainter& painter, int frame) const;
    void paintLoop(QPainter& painter) const;
    void paintBeats(QPainter& painter) const;
    int frameCount() const { return static_cast<int>(curve_.opacification.size()); }
    int frameAt(double x) const;
    std::optional<LoopEnd> loopEndAt(const QPointF& pos) const;
    void dragLoop(int frame);
    void pressBars(int frame, Qt::KeyboardModifiers modifiers);
    void request(int frame);
    void extendMask(int step);
    bool isMask(int frame) const;

    FrameCurve curve_;
    std::vector<int> masks_;
    bool masksInUse_ = false;
    std::optional<std::pair<int, int>> markedRange_;   ///< first and last frame of the range being marked
    core::FrameRange loop_;
    std::optional<LoopEnd> draggedEnd_;
    int current_ = 0;
};

}   // namespace angiopose::ui
