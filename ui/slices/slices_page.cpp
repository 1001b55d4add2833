#include "ui/slices/slices_page.h"

#include "ui/slices/window_bar.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QScrollArea>
#include <QScrollBar>
#include <QVBoxLayout>

#include <algorithm>

namespace angiopose::ui {
namespace {

constexpr int gapPx = 2;   // gap between the slices, which have no separator lines
constexpr int panelWidth = 300;   // wide enough for label names and volumes
constexpr int minSlicesWidth = 260;   // minimum width of the slices next to a panel

}   // namespace

SlicesPage::SlicesPage(SliceModel& model, QWidget* parent)
    : QWidget(parent), bar_(new WindowBar(model)), parts_(new QHBoxLayout)
{
    for (const core::BodyPlane plane : core::bodyPlanes) {
        views_[plane] = new SliceView(model, plane);
        connect(views_[plane], &SliceView::enlargeRequested, this, &SlicesPage::closeRequested);
    }
    connect(bar_, &WindowBar::closeRequested, this, &SlicesPage::closeRequested);
    connect(bar_, &WindowBar::popOutRequested, this, &SlicesPage::popOutRequested);
    auto* upright = new QVBoxLayout;
    upright->setSpacing(gapPx);
    upright->addWidget(views_[core::BodyPlane::Coronal]);
    upright->addWidget(views_[core::BodyPlane::Sagittal]);
    auto* slices = new QHBoxLayout;
    slices->setSpacing(gapPx);
    slices->addWidget(views_[core::BodyPlane::Axial], 3);
    slices->addLayout(upright, 2);
    parts_->setSpacing(gapPx);
    parts_->addLayout(slices, 3);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(bar_);
    layout->addLayout(parts_, 1);
    setProperty("role", "column");
    setAttribute(Qt::WA_StyledBackground);
    setFocusProxy(views_[core::BodyPlane::Axial]);
}

void SlicesPage::setSidePanel(QWidget* panel)
{
    panel_ = panel;
    panelArea_ = new QScrollArea;   // scrolls if the panel is taller than the page
    panelArea_->setProperty("role", "column");
    panelArea_->setWidget(panel);
    panelArea_->setWidgetResizable(true);
    panelArea_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    parts_->addWidget(panelArea_);
    placePanel();
}

void SlicesPage::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    placePanel();
}

/// Updates the panel width after a language change.
bool SlicesPage::event(QEvent* event)
{
    const bool isDone = QWidget::event(event);
    if (event->type() == QEvent::LayoutRequest) {
        placePanel();
    }
    return isDone;
}

/// Places the panel next to the slices with the width that its text needs, or below them at full width.
void SlicesPage::placePanel()
{
    if (!panel_) {
        return;
    }
    const int scrollBar = panelArea_->verticalScrollBar()->sizeHint().width();
    const int least = std::max(panel_->minimumWidth(), panel_->minimumSizeHint().width()) + scrollBar;
    const bool isBelow = width() < least + minSlicesWidth;
    parts_->setDirection(isBelow ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight);
    parts_->setStretchFactor(panelArea_, isBelow ? 2 : 0);
    panelArea_->setMinimumWidth(isBelow ? 0 : least);
    panelArea_->setMaximumWidth(isBelow ? QWIDGETSIZE_MAX : std::max(least, panelWidth + scrollBar));
    panelArea_->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Expanding);
}

}   // namespace angiopose::ui
