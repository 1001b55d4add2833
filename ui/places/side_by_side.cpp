#include "ui/places/side_by_side.h"

#include "ui/places/view_pane.h"
#include "ui/views/angiogram_view.h"

#include <QGridLayout>
#include <QSplitter>
#include <QVBoxLayout>

#include <algorithm>

namespace angiopose::ui {
namespace {

constexpr std::size_t panesInOneColumn = 3;

}   // namespace

SideBySide::SideBySide(AngiogramView& shown, QWidget* parent)
    : QWidget(parent),
      title_(new PaneTitle),
      shown_(&shown),
      others_(new QWidget),
      grid_(new QGridLayout(others_)),
      halves_(new QSplitter(Qt::Horizontal))
{
    auto* working = new QWidget;
    auto* column = new QVBoxLayout(working);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(title_);
    column->addWidget(shown_, 1);
    title_->setShown(true);
    title_->hide();
    grid_->setContentsMargins(0, 0, 0, 0);
    grid_->setSpacing(1);
    others_->hide();
    halves_->addWidget(working);
    halves_->addWidget(others_);
    halves_->setHandleWidth(1);
    halves_->setChildrenCollapsible(false);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(halves_);
    setFocusProxy(shown_);
}

void SideBySide::setPaneCount(std::size_t count)
{
    if (count == count_) {
        return;
    }
    count_ = count;
    while (panes_.size() < count) {
        panes_.push_back(new ViewPane(others_));
        emit paneMade(panes_.back());
    }
    place();
}

/// In rows, as many columns as keep the panes about as high as they are wide.
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
    others_->setVisible(count_ > 0);
    const int wide = std::max(2, halves_->width());
    const int forOthers = count_ == 0 ? 0 : count_ > 1 && columns == 1 ? wide / 3 : wide / 2;
    halves_->setSizes({wide - forOthers, forOthers});
}

std::vector<AngiogramView*> SideBySide::images()
{
    std::vector<AngiogramView*> images{shown_};
    std::ranges::transform(panes_.begin(), panes_.begin() + static_cast<std::ptrdiff_t>(count_),
                           std::back_inserter(images), [](ViewPane* pane) { return &pane->image(); });
    return images;
}

}   // namespace angiopose::ui
