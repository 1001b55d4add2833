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

/// Plays the shown run: how fast, which part, loop or back and forth. The case hears nothing of it until the user
/// stops: then the frame on screen becomes its frame, as if it had been scrolled to, in one undo step. Esc and whatever
/// else ends the motion go back to the case's frame.
class CineController : public QObject {
    Q_OBJECT
public:
    CineController(CaseDocument& document, ViewSync& sync, ReviewController& review, ui::WindowActions& actions,
                   ui::BottomStrip& strip, QObject* parent = nullptr);

    const core::FrameRange& loop() const { return loop_; }   ///< frames that play
    double speed() const { return speed_; }   ///< times as fast as the run was taken
    core::CineOrder order() const { return order_; }

private:
    void connectCommands();
    void followDocument();
    void setPlaying(bool on);
    void keepFrame();
    void restart();
    void showDue();
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
    std::shared_ptr<const core::Angiogram> run_;   ///< as stored
    core::FrameRange loop_;
    double speed_;
    core::CineOrder order_;
    std::optional<core::CineClock> clock_;   ///< while it plays
    std::optional<int> stoppedAt_;
    QElapsedTimer time_;
    QTimer timer_;
};

}   // namespace angiopose::app
