#include "ui/places/view_pane.h"

#include "ui/controls/section.h"
#include "ui/views/angiogram_view.h"
#include "ui/words/spoken.h"

#include <QContextMenuEvent>
#include <QHBoxLayout>
#include <QMouseEvent>
#include <QScrollBar>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <algorithm>
#include <climits>

namespace angiopose::ui {

PaneTitle::PaneTitle(QWidget* parent)
    : QWidget(parent), title_(new ElidedLabel("label")), note_(new ElidedLabel("hint"))
{
    setProperty("role", "column");
    setAttribute(Qt::WA_StyledBackground);
    setCursor(Qt::PointingHandCursor);
    note_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(10, 3, 10, 3);
    layout->setSpacing(10);
    layout->addWidget(title_, 3);
    layout->addWidget(note_, 2);
}

void PaneTitle::showWords(const QString& title, const QString& note, const QString& tip)
{
    title_->showText(title);
    note_->showText(note);
    showNote();
    for (QWidget* part : {static_cast<QWidget*>(this), static_cast<QWidget*>(title_), static_cast<QWidget*>(note_)}) {
        part->setToolTip(tip);
    }
}

/// Where there is little room it is for the name.
void PaneTitle::showNote()
{
    constexpr int narrowPx = 220;
    note_->setVisible(!note_->text().isEmpty() && width() >= narrowPx);
}

void PaneTitle::resizeEvent(QResizeEvent*)
{
    showNote();
}

void PaneTitle::setShown(bool shown)
{
    isShown_ = shown;
    setRole(title_, shown ? "title" : "label");
    setCursor(shown ? Qt::ArrowCursor : Qt::PointingHandCursor);
}

QString PaneTitle::title() const
{
    return title_->text();
}

QString PaneTitle::note() const
{
    return note_->text();
}

void PaneTitle::mouseReleaseEvent(QMouseEvent* event)
{
    if (event->button() == Qt::LeftButton && !isShown_ && rect().contains(event->position().toPoint())) {
        emit clicked();
    }
}

void PaneTitle::contextMenuEvent(QContextMenuEvent* event)
{
    event->accept();
    emit menuRequested(event->globalPos());
}

ViewPane::ViewPane(QWidget* parent)
    : QWidget(parent),
      title_(new PaneTitle),
      image_(new AngiogramView(ImageRole::Beside)),
      frames_(new QScrollBar(Qt::Horizontal))
{
    setProperty("role", "canvas");
    setAttribute(Qt::WA_StyledBackground);
    withName(frames_, [] { return tr("Frames of this view"); });
    frames_->setPageStep(1);
    frames_->hide();
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(title_);
    layout->addWidget(image_, 1);
    layout->addWidget(frames_);
    connect(title_, &PaneTitle::clicked, this, &ViewPane::chosen);
    connect(title_, &PaneTitle::menuRequested, this, &ViewPane::menuRequested);
    connect(image_, &AngiogramView::roomRequested, this, &ViewPane::chosen);
    connect(image_, &AngiogramView::menuRequested, this, &ViewPane::menuRequested);
    connect(image_, &AngiogramView::frameStepRequested, this, &ViewPane::stepFrame);
    connect(frames_, &QScrollBar::valueChanged, this, &ViewPane::frameRequested);
}

void ViewPane::showFrame(int frame, int count)
{
    const QSignalBlocker quiet(frames_);
    frames_->setRange(0, std::max(0, count - 1));
    frames_->setValue(frame);
    frames_->setVisible(count > 1);
    image_->setFramePosition(frame, count);
}

void ViewPane::stepFrame(int step)
{
    const bool isEnd = step == INT_MIN || step == INT_MAX;
    const int wanted = isEnd ? step : frames_->value() + step;
    emit frameRequested(std::clamp(wanted, 0, frames_->maximum()));
}

}   // namespace angiopose::ui
