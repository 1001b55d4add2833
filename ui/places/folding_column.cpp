#include "ui/places/folding_column.h"

#include "ui/places/fold_button.h"

#include <QApplication>
#include <QHBoxLayout>
#include <QResizeEvent>
#include <QSplitter>

namespace angiopose::ui {

FoldingColumn::FoldingColumn(ColumnSide side, QWidget& content, const Words& behind, QWidget* parent)
    : QWidget(parent), side_(side), content_(&content), rail_(new ColumnRail(side, behind))
{
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(content_);
    layout->addWidget(rail_);
    connect(rail_, &QAbstractButton::clicked, this, [this] { setFolded(false); });
    rail_->hide();
}

void FoldingColumn::placeButton(QSplitterHandle& border)
{
    const Words words = [rail = rail_] { return rail->text(); };
    auto* button = new FoldButton(side_, words);
    connect(button, &QAbstractButton::clicked, this, [this] { setFolded(true); });
    auto* layout = new QVBoxLayout(&border);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(button, 0, Qt::AlignCenter);
    button_ = button;
    place();
}

void FoldingColumn::setFolded(bool folded)
{
    if (folded == isFolded_) {
        return;
    }
    const QWidget* had = QApplication::focusWidget();
    const bool hadFocus = had && (isAncestorOf(had) || had == button_);
    isFolded_ = folded;
    placeRail();
    emit foldedChanged(folded);
    showContent();
    if (hadFocus) {   // the keys stay at what was folded, or unfolded
        QWidget* next = folded ? rail_ : button_;
        next->setFocus(Qt::OtherFocusReason);
    }
}

void FoldingColumn::holdOpen(bool hold)
{
    if (hold != isHeldOpen_) {
        isHeldOpen_ = hold;
        place();
    }
}

void FoldingColumn::place()
{
    placeRail();
    showContent();
}

void FoldingColumn::showContent()
{
    content_->setVisible(!isRail());
}

bool FoldingColumn::isRail() const
{
    return isFolded_ && !isHeldOpen_;
}

/// Before the content comes and after it went: it is laid out once, for the width that it keeps.
void FoldingColumn::placeRail()
{
    const bool isRail = this->isRail();
    if (isRail) {
        content_->hide();
    }
    rail_->setVisible(isRail);
    const int railWidth = rail_->sizeHint().width();
    setMinimumWidth(isRail ? railWidth : 0);
    setMaximumWidth(isRail ? railWidth : QWIDGETSIZE_MAX);
    if (button_) {
        button_->setVisible(!isRail);
        button_->parentWidget()->setEnabled(!isRail);   // a rail has one width
    }
}

void FoldingColumn::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    if (!isFolded_ && !isHeldOpen_ && content_->isVisible()) {
        openWidth_ = event->size().width();
    }
}

}   // namespace angiopose::ui
