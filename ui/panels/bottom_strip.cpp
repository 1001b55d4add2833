#include "ui/panels/bottom_strip.h"

#include "ui/controls/section.h"
#include "ui/words/retranslation.h"

#include <QHBoxLayout>
#include <QProgressBar>
#include <QPushButton>
#include <QVBoxLayout>

namespace angiopose::ui {
namespace {

constexpr int progressSteps = 1000;
constexpr int stripHeight = 88;
constexpr int besideProgressPx = 10;   // width of the progress bar and the gap before it

}   // namespace

BottomStrip::BottomStrip(QWidget* parent)
    : QWidget(parent),
      frames_(new FrameBars),
      play_(new PlayBar),
      frameNote_(new ElidedLabel("hint")),
      saveState_(new ElidedLabel("label")),
      undoState_(new ElidedLabel("hint")),
      status_(roleLabel("label")),
      progress_(new QProgressBar),
      stop_(withText(new QPushButton, [] { return tr("Stop"); }))
{
    setProperty("role", "strip");
    setAttribute(Qt::WA_StyledBackground);
    auto* left = new QVBoxLayout;
    left->setSpacing(4);
    left->addWidget(saveState_);
    left->addWidget(undoState_);
    left->addStretch(1);

    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(14, 8, 14, 8);
    layout->setSpacing(18);
    layout->addLayout(left, 3);
    layout->addLayout(makeFrameArea(), 12);
    layout->addLayout(makeTaskArea(), 4);
    setFixedHeight(stripHeight);
    showFrameNote({});
    keepTranslated(this, [this] {
        if (progress_->isHidden() || task_.isEmpty()) {
            showIdle(tr("Ready"));
        }
    });
}

/// Lays out the frame bars with the playback controls and a note below.
QLayout* BottomStrip::makeFrameArea()
{
    auto* frames = new QVBoxLayout;
    frames->setSpacing(3);
    frames->addWidget(frames_, 1);
    auto* below = new QHBoxLayout;
    below->setSpacing(10);
    below->addWidget(play_);
    below->addWidget(frameNote_, 1);
    frames->addLayout(below);
    play_->hide();
    connect(frames_, &FrameBars::frameRequested, this, &BottomStrip::frameRequested);
    connect(frames_, &FrameBars::maskRangeMarked, this, &BottomStrip::maskRangeMarked);
    connect(frames_, &FrameBars::loopMarked, this, &BottomStrip::loopMarked);
    connect(frames_, &FrameBars::plotRequested, this, &BottomStrip::plotRequested);
    return frames;
}

/// Lays out the running task with its progress and a Stop button; their space remains reserved while idle.
QLayout* BottomStrip::makeTaskArea()
{
    status_->setWordWrap(true);
    status_->setTextFormat(Qt::PlainText);
    status_->setMinimumWidth(1);
    status_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    progress_->setTextVisible(false);
    progress_->setFixedHeight(4);
    withAccessibleName(progress_, [] { return tr("Progress"); });
    withAccessibleName(stop_, [] { return tr("Stop the running task"); });
    QSizePolicy keepsPlace = stop_->sizePolicy();
    keepsPlace.setRetainSizeWhenHidden(true);
    stop_->setSizePolicy(keepsPlace);
    connect(stop_, &QPushButton::clicked, this, &BottomStrip::stopRequested);

    auto* words = new QVBoxLayout;
    words->setSpacing(6);
    words->addWidget(status_, 1);
    words->addWidget(progress_);
    auto* task = new QHBoxLayout;
    task->setSpacing(10);
    task->addLayout(words, 1);
    task->addWidget(stop_, 0, Qt::AlignVCenter);
    return task;
}

void BottomStrip::showFrames(const FrameCurve& curve)
{
    frames_->showFrames(curve);
}

void BottomStrip::showMasks(const std::vector<int>& frames, bool inUse)
{
    frames_->showMasks(frames, inUse);
}

void BottomStrip::showCurrentFrame(int frame)
{
    frames_->showCurrent(frame);
}

void BottomStrip::showLoop(const core::FrameRange& range)
{
    frames_->showLoop(range);
    play_->setVisible(range.count() > 1);
}

void BottomStrip::showFrameNote(const QString& note)
{
    frameNote_->showText(note);
    frameNote_->setVisible(!note.isEmpty());   // without an angiogram, the status text uses this space
    frames_->setVisible(!note.isEmpty());
}

void BottomStrip::showSaveState(const QString& text)
{
    saveState_->showText(text);
}

void BottomStrip::showUndoState(const QString& text)
{
    undoState_->showText(text);
}

void BottomStrip::showStatus(const QString& text)
{
    messageLog_.add(text);
    showTask(text);
}

void BottomStrip::showTask(const QString& text)
{
    task_ = text;
    status_->setToolTip(text);
    fitTask();
}

void BottomStrip::resizeEvent(QResizeEvent*)
{
    fitTask();
}

/// Elides the status text to the available width; the tooltip and the message log show it in full.
void BottomStrip::fitTask()
{
    const int availablePx = contentsRect().height() - layout()->contentsMargins().top() -
                            layout()->contentsMargins().bottom() - (progress_->isHidden() ? 0 : besideProgressPx);
    const auto fits = [&](const QString& text) {
        return status_->fontMetrics()
                   .boundingRect(QRect(0, 0, status_->width(), 10 * stripHeight), Qt::TextWordWrap, text)
                   .height() <= availablePx;
    };
    const auto shorten = [this](qsizetype length) { return task_.left(length).trimmed() + QStringLiteral(" …"); };
    if (fits(task_)) {
        status_->setText(task_);
        return;
    }
    qsizetype fitting = 0;
    qsizetype tooLong = task_.size();
    while (tooLong - fitting > 1) {
        const qsizetype middle = (fitting + tooLong) / 2;
        (fits(shorten(middle)) ? fitting : tooLong) = middle;
    }
    status_->setText(shorten(fitting));
}

void BottomStrip::showBusy(const QString& text)
{
    progress_->setRange(0, 0);
    progress_->show();
    stop_->show();
    showTask(text);
}

void BottomStrip::showProgress(const QString& text, double fraction)
{
    progress_->setRange(0, progressSteps);
    progress_->setValue(static_cast<int>(fraction * progressSteps));
    progress_->show();
    stop_->show();
    showTask(text);
}

void BottomStrip::showIdle(const QString& text)
{
    if (text != tr("Ready")) {
        messageLog_.add(text);
    }
    progress_->hide();
    stop_->hide();
    showTask(text);
}

}   // namespace angiopose::ui
