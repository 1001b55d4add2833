#pragma once

#include "ui/controls/section.h"
#include "ui/panels/message_log.h"
#include "ui/panels/play_bar.h"
#include "ui/plots/frame_bars.h"

#include <QWidget>

class QLayout;
class QProgressBar;
class QPushButton;

namespace angiopose::ui {

/// Bottom strip of the window: autosave and undo on the left, frames in the middle, the current task on the right.
class BottomStrip : public QWidget {
    Q_OBJECT
public:
    explicit BottomStrip(QWidget* parent = nullptr);

    PlayBar& play() { return *play_; }
    void showFrames(const FrameCurve& curve);
    void showMasks(const std::vector<int>& frames, bool inUse);   ///< marks mask frames below their bars
    void showCurrentFrame(int frame);
    void showLoop(const core::FrameRange& range);   ///< shows the playback range
    void showFrameNote(const QString& note);
    void showSaveState(const QString& text);
    void showUndoState(const QString& text);
    void showStatus(const QString& text);   ///< shows the current activity, or "Ready"
    void showBusy(const QString& text);   ///< shows a task of unknown duration
    void showProgress(const QString& text, double fraction);
    void showIdle(const QString& text);
    void remember(const QString& text) { messageLog_.add(text); }   ///< logs a message that is shown elsewhere
    const MessageLog& reported() const { return messageLog_; }   ///< message log, without progress messages

signals:
    void frameRequested(int frame);
    void maskRangeMarked(int first, int last);
    void loopMarked(const angiopose::core::FrameRange& range);
    void plotRequested();
    void stopRequested();

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    QLayout* makeFrameArea();
    QLayout* makeTaskArea();
    void showTask(const QString& text);
    void fitTask();

    QString task_;   ///< full status text, not elided
    MessageLog messageLog_;
    FrameBars* frames_;
    PlayBar* play_;
    ElidedLabel* frameNote_;
    ElidedLabel* saveState_;
    ElidedLabel* undoState_;
    QLabel* status_;
    QProgressBar* progress_;
    QPushButton* stop_;
};

}   // namespace angiopose::ui
