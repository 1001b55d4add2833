#pragma once

#include "core/viewing/cine_clock.h"

#include <QWidget>

#include <array>

class QComboBox;

namespace angiopose::ui {

class GlyphButton;

/// Playback speeds relative to the acquisition frame rate.
inline constexpr std::array playSpeeds{0.25, 0.5, 1.0, 2.0, 4.0};

/// Frame time of a run.
struct FrameTime {
    double ms = 0.0;
    bool isAssumed = false;   ///< true if the DICOM header does not state the frame time
};

/// Playback controls: play/pause, speed, and whether playback loops or reverses at the end. Passive view: displays the
/// given state and emits signals for user actions.
class PlayBar : public QWidget {
    Q_OBJECT
public:
    explicit PlayBar(QWidget* parent = nullptr);

    void showFrameTime(const FrameTime& time);
    void showSpeed(double speed);   ///< selects the nearest of `playSpeeds`
    void showOrder(core::CineOrder order);
    void showPlaying(bool playing);

signals:
    void playClicked();
    void speedPicked(double speed);
    void orderPicked(angiopose::core::CineOrder order);

private:
    void updateTexts();

    GlyphButton* play_;
    QComboBox* speed_;
    GlyphButton* order_;
    FrameTime frameTime_;
    core::CineOrder shownOrder_ = core::CineOrder::Loop;
    bool isPlaying_ = false;
};

}   // namespace angiopose::ui
