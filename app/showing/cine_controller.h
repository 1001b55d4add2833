#pragma once

#include "app/document/case_document.h"
#include "app/showing/review_controller.h"
#include "app/showing/view_sync.h"
#include "core/viewing/cine_clock.h"

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

#include <memory>
#include <optional>

namespace angiopose::app {

/// Plays the shown cine run with adjustable speed and frame range, in a loop or back and forth. Playback does not
/// change the case. When the user stops it, the frame on screen becomes the case's frame in one undo step; Esc, or
/// anything else that ends playback, returns to the case's frame.
class CineController : public QObject {
    Q_OBJECT
public:
    CineController(CaseDocument& document, ViewSync& sync, ReviewController& review, ui::WindowActions& actions,
                   ui::BottomStrip& strip, QObject* parent = nullptr);

    const core::FrameRange& loop() const { return loop_; }   ///< frame range of playback
    double speed() const { return speed_; }   ///< playback speed relative to the acquisition rate
    core::CineOrder order() const { return order_; }

private:
    void connectCommands();
    void updateFromDocument();
    void setPlaying(bool on);
    void adoptFrame();
    void restart();
    void showDueFrame();
    void chooseSpeed(double speed);
    void changeSpeed(int step);
    void chooseOrder(core::CineOrder order);
    void chooseLoop(const core::FrameRange& range);
    int frameCount() const;

    CaseDocument& document_;
    ViewSync& sync_;
    ReviewController& review_;
    ui::WindowActions& actions_;
    ui::BottomStrip& strip_;
    std::shared_ptr<const core::Angiogram> run_;   ///< frames as stored, before subtraction
    core::FrameRange loop_;
    double speed_;
    core::CineOrder order_;
    std::optional<core::CineClock> clock_;   ///< set only during playback
    std::optional<int> stoppedFrame_;
    QElapsedTimer elapsed_;
    QTimer timer_;
};

}   // namespace angiopose::app
