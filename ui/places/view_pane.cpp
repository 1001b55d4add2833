#include "ui/places/view_pane.h"

#include "ui/places/pane_title.h"
#include "ui/views/angiogram_view.h"
#include "ui/words/spoken.h"

#include <QScrollBar>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include <algorithm>
#include <climits>

namespace angiopose::ui {

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
