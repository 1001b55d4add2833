#include "ui/places/side_by_side.h"

#include "ui/controls/section.h"
#include "ui/views/angiogram_view.h"
#include "ui/words/retranslation.h"

#include <QContextMenuEvent>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QMouseEvent>
#include <QScrollBar>
#include <QSignalBlocker>
#include <QSplitter>
#include <QVBoxLayout>
#include <algorithm>
#include <climits>

namespace angiopose::ui {
namespace {

constexpr std::size_t panesInOneColumn = 3;

}   // namespace

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

void PaneTitle::showTexts(const QString& title, const QString& note, const QString& tip)
{
    title_->showText(title);
    note_->showText(note);
    showNote();
    for (QWidget* part : {static_cast<QWidget*>(this), static_cast<QWidget*>(title_), static_cast<QWidget*>(note_)}) {
        part->setToolTip(tip);
    }
}

/// Shows the note only if the pane is wide enough for both the view name and the note.
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
      image_(new AngiogramView(ImageRole::Secondary)),
      frames_(new QScrollBar(Qt::Horizontal))
{
    setProperty("role", "canvas");
    setAttribute(Qt::WA_StyledBackground);
    withAccessibleName(frames_, [] { return tr("Frames of this view"); });
    frames_->setPageStep(1);
    frames_->hide();
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(title_);
    layout->addWidget(image_, 1);
    layout->addWidget(frames_);
    connect(title_, &PaneTitle::clicked, this, &ViewPane::viewChosen);
    connect(title_, &PaneTitle::menuRequested, this, &ViewPane::menuRequested);
    connect(image_, &AngiogramView::enlargeRequested, this, &ViewPane::viewChosen);
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
    const int target = isEnd ? step : frames_->value() + step;
    emit frameRequested(std::clamp(target, 0, frames_->maximum()));
}

SideBySide::SideBySide(AngiogramView& shown, QWidget* parent)
    : QWidget(parent),
      title_(new PaneTitle),
      primaryImage_(&shown),
      paneArea_(new QWidget),
      grid_(new QGridLayout(paneArea_)),
      splitter_(new QSplitter(Qt::Horizontal))
{
    auto* working = new QWidget;
    auto* column = new QVBoxLayout(working);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(title_);
    column->addWidget(primaryImage_, 1);
    title_->setShown(true);
    title_->hide();
    grid_->setContentsMargins(0, 0, 0, 0);
    grid_->setSpacing(1);
    paneArea_->hide();
    splitter_->addWidget(working);
    splitter_->addWidget(paneArea_);
    splitter_->setHandleWidth(1);
    splitter_->setChildrenCollapsible(false);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(splitter_);
    setFocusProxy(primaryImage_);
}

void SideBySide::setPaneCount(std::size_t count)
{
    if (count == count_) {
        return;
    }
    count_ = count;
    while (panes_.size() < count) {
        panes_.push_back(new ViewPane(paneArea_));
        emit paneCreated(panes_.back());
    }
    place();
}

/// Arranges the panes in a grid whose number of columns makes them most nearly square.
void SideBySide::place()
{
    const std::size_t columns = count_ > panesInOneColumn ? 2 : 1;
    for (std::size_t i = 0; i < panes_.size(); ++i) {
        grid_->removeWidget(panes_[i]);
        panes_[i]->setVisible(i < count_);
        if (i < count_) {
            grid_->addWidget(panes_[i], static_cast<int>(i / columns), static_cast<int>(i % columns));
        }
    }
    title_->setVisible(count_ > 0);
    paneArea_->setVisible(count_ > 0);
    const int wide = std::max(2, splitter_->width());
    const int forOthers = count_ == 0 ? 0 : count_ > 1 && columns == 1 ? wide / 3 : wide / 2;
    splitter_->setSizes({wide - forOthers, forOthers});
}

std::vector<AngiogramView*> SideBySide::images()
{
    std::vector<AngiogramView*> images{primaryImage_};
    std::ranges::transform(panes_.begin(), panes_.begin() + static_cast<std::ptrdiff_t>(count_),
                           std::back_inserter(images), [](ViewPane* pane) { return &pane->image(); });
    return images;
}

}   // namespace angiopose::ui
