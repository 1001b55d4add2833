#pragma once

#include "core/viewing/cine_clock.h"

#include <QWidget>

#include <array>

class QComboBox;

namespace angiopose::ui {

class GlyphButton;

/// How fast a run may be played, times as fast as it was taken.
inline constexpr std::array playSpeeds{0.25, 0.5, 1.0, 2.0, 4.0};

/// How long a frame of the run was taken, and who says so.
struct FrameTime {
    double ms = 0.0;
    bool isAssumed = false;   ///< the header does not tell
};

/// Play and pause, speed, and whether the run starts over or turns back at its end. Shows what it is told, reports what
/// the user wants.
class PlayBar : public QWidget {
    Q_OBJECT
public:
    explicit PlayBar(QWidget* parent = nullptr);

    void showFrameTime(const FrameTime& time);
    void showSpeed(double speed);   ///< of `playSpeeds`, the nearest else
    void showOrder(core::CineOrder order);
    void showPlaying(bool playing);

signals:
    void playClicked();
    void speedPicked(double speed);
    void orderPicked(angiopose::core::CineOrder order);

private:
    void sayWords();

    GlyphButton* play_;
    QComboBox* speed_;
    GlyphButton* order_;
    FrameTime time_;
    core::CineOrder shownOrder_ = core::CineOrder::Loop;
    bool isPlaying_ = false;
};

}   // namespace angiopose::ui
