#pragma once

#include "core/viewing/cine_clock.h"

#include <QWidget>

#include <optional>
#include <utility>
#include <vector>

namespace angiopose::ui {

/// What is known of a run's frames.
struct FrameCurve {
    std::vector<double> opacification;   ///< 0…1, one per frame
    int suggested = 0;
    double frameTimeMs = 0.0;   ///< 0: unknown
    std::vector<int> rWaves = {};   ///< frames at the R waves of the ECG
};

/// "Frame 5, 0.33 s", with what is special about it.
QString describeFrame(const FrameCurve& curve, const std::vector<int>& masks, int frame);

/// The frames of a run as bars of opacification; a click or ← → shows another frame. Shift marks the mask frames: by
/// drag, or with ← → from the frame on. The lane above the bars shows what part of the run plays; its ends are dragged.
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
    void loopMarked(const angiopose::core::FrameRange& range);   ///< while it is dragged
    void plotRequested();   ///< double click: the curve, larger

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
    std::optional<LoopEnd> loopEndAt(const QPointF& place) const;
    void dragLoop(int frame);
    void pressBars(int frame, Qt::KeyboardModifiers modifiers);
    void request(int frame);
    void extendMask(int step);
    bool isMask(int frame) const;

    FrameCurve curve_;
    std::vector<int> masks_;
    bool masksInUse_ = false;
    std::optional<std::pair<int, int>> marking_;   ///< from, to
    core::FrameRange loop_;
    std::optional<LoopEnd> dragged_;
    int current_ = 0;
};

}   // namespace angiopose::ui