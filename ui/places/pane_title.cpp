#include "ui/places/pane_title.h"

#include "ui/controls/elided_label.h"
#include "ui/controls/section.h"

#include <QContextMenuEvent>
#include <QHBoxLayout>
#include <QMouseEvent>

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

}   // namespace angiopose::ui
