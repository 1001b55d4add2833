#include "ui/places/folding_column.h"

#include "ui/actions/key_hint.h"
#include "ui/theme/active_theme.h"

#include <QApplication>
#include <QDataStream>
#include <QHBoxLayout>
#include <QIODevice>
#include <QPainter>
#include <QResizeEvent>
#include <QSplitter>
#include <algorithm>

namespace angiopose::ui {
namespace {

constexpr int railWidth = 30;
constexpr int chevronFromTop = 22;
constexpr int wordsFromTop = 42;

Command commandOf(ColumnSide side)
{
    return side == ColumnSide::Left ? Command::FoldLeft : Command::FoldRight;
}

constexpr qint32 layoutVersion = 1;

int shareOf(int width, double fraction, int least, int most)
{
    return std::clamp(static_cast<int>(fraction * width), least, most);
}

}   // namespace

void paintChevron(QPainter& painter, const QPointF& at, ColumnSide side)
{
    const double sign = side == ColumnSide::Left ? -1.0 : 1.0;
    painter.drawPolyline(
        QPolygonF({at + QPointF(-2.0 * sign, -4.5), at + QPointF(2.0 * sign, 0.0), at + QPointF(-2.0 * sign, 4.5)}));
}

ColumnRail::ColumnRail(ColumnSide side, const LocalizedText& contentName, QWidget* parent)
    : QAbstractButton(parent), side_(side)
{
    withText(this, contentName);
    withAccessibleName(this, [contentName] { return tr("Expand panel: %1").arg(contentName()); });
    withToolTip(this, [side, contentName] {
        return tooltipWithShortcut(tr("Expand: %1").arg(contentName()), commandOf(side));
    });
    setCursor(Qt::PointingHandCursor);
    setFocusPolicy(Qt::TabFocus);   // avoids a focus rectangle after a click
    setAttribute(Qt::WA_Hover);
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Expanding);
}

QSize ColumnRail::sizeHint() const
{
    return {railWidth, 320};
}

int ColumnRail::maxTextLengthPx(int height)
{
    return height - wordsFromTop - 8;
}

/// Draws the text along the rail, rotated clockwise.
void ColumnRail::paintEvent(QPaintEvent*)
{
    const Palette& colors = activePalette();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(rect(), toQColor(underMouse() ? mixed(colors.panel, colors.accent, 0.10) : colors.panel));
    const QColor tone = toQColor(underMouse() || hasFocus() ? colors.textStrong : colors.label);
    painter.setPen(QPen(tone, 1.6, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    paintChevron(painter, {0.5 * width(), chevronFromTop},
                 side_ == ColumnSide::Left ? ColumnSide::Right : ColumnSide::Left);
    const int textLength = maxTextLengthPx(height());
    painter.save();
    painter.translate(0.5 * width(), wordsFromTop);
    painter.rotate(90.0);
    painter.drawText(QRect(0, -width() / 2, textLength, width()), Qt::AlignLeft | Qt::AlignVCenter,
                     painter.fontMetrics().elidedText(text(), Qt::ElideRight, textLength));
    painter.restore();
    if (hasFocus()) {
        painter.setRenderHint(QPainter::Antialiasing, false);
        painter.setPen(toQColor(colors.accent));
        painter.drawRect(rect().adjusted(0, 0, -1, -1));
    }
}

FoldButton::FoldButton(ColumnSide side, const LocalizedText& folds, QWidget* parent)
    : QAbstractButton(parent), side_(side)
{
    withAccessibleName(this, [folds] { return tr("Collapse panel: %1").arg(folds()); });
    withToolTip(this, [side, folds] {
        return tooltipWithShortcut(tr("Collapse: %1").arg(folds()),
                                   side == ColumnSide::Left ? Command::FoldLeft : Command::FoldRight);
    });
    setCursor(Qt::PointingHandCursor);
    setFocusPolicy(Qt::TabFocus);   // avoids a focus rectangle after a click
    setAttribute(Qt::WA_Hover);
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
}

QSize FoldButton::sizeHint() const
{
    return {9, 56};
}

void FoldButton::paintEvent(QPaintEvent*)
{
    const Palette& colors = activePalette();
    const bool isPointed = underMouse() || hasFocus();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(toQColor(isPointed ? mixed(colors.panel, colors.accent, 0.25) : colors.line));
    painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 3.0, 3.0);
    painter.setPen(
        QPen(toQColor(isPointed ? colors.textStrong : colors.label), 1.4, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    paintChevron(painter, QRectF(rect()).center(), side_);
    if (hasFocus()) {
        painter.setBrush(Qt::NoBrush);
        painter.setPen(toQColor(colors.accent));
        painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 3.0, 3.0);
    }
}

FoldingColumn::FoldingColumn(ColumnSide side, QWidget& content, const LocalizedText& contentName, QWidget* parent)
    : QWidget(parent), side_(side), content_(&content), rail_(new ColumnRail(side, contentName))
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
    const LocalizedText words = [rail = rail_] { return rail->text(); };
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
    if (hadFocus) {   // moves the keyboard focus to the rail after folding, or to the fold button after unfolding
        QWidget* next = folded ? rail_ : button_;
        next->setFocus(Qt::OtherFocusReason);
    }
}

void FoldingColumn::setHeldOpen(bool isHeld)
{
    if (isHeld != isHeldOpen_) {
        isHeldOpen_ = isHeld;
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

/// Called before the content is shown and after it is hidden, so that it is laid out only once, at its final width.
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
        button_->parentWidget()->setEnabled(!isRail);   // a rail cannot be resized
    }
}

void FoldingColumn::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    if (!isFolded_ && !isHeldOpen_ && content_->isVisible()) {
        openWidth_ = event->size().width();
    }
}

ColumnLayout defaultColumns(Activity work, int windowWidth)
{
    ColumnLayout columns;
    switch (work) {
        case Activity::Tracing:   // more space for the slices and the 3-D view
            columns.leftWidth = shareOf(windowWidth, 0.34, 300, 760);
            columns.cornerFraction = 0.68;
            columns.isRightFolded = true;
            break;
        case Activity::Registering:
            break;
        case Activity::Reviewing:   // more space for the image and the result panel
            columns.rightWidth = shareOf(windowWidth, 0.28, 320, 480);
            columns.isLeftFolded = true;
            break;
    }
    return columns;
}

QByteArray toBytes(const ActivityLayout& layout)
{
    QByteArray bytes;
    QDataStream stream(&bytes, QIODevice::WriteOnly);
    const ColumnLayout& columns = layout.columns;
    stream << layoutVersion << qint32{columns.leftWidth} << qint32{columns.rightWidth} << columns.isLeftFolded
           << columns.isRightFolded << columns.cornerFraction << layout.areSlicesEnlarged << qint32{layout.cornerPlane};
    return bytes;
}

std::optional<ActivityLayout> activityLayoutFromBytes(const QByteArray& bytes)
{
    QDataStream stream(bytes);
    qint32 version = 0;
    qint32 left = 0;
    qint32 right = 0;
    qint32 plane = 0;
    ActivityLayout layout;
    stream >> version >> left >> right >> layout.columns.isLeftFolded >> layout.columns.isRightFolded >>
        layout.columns.cornerFraction >> layout.areSlicesEnlarged >> plane;
    const bool isSound = stream.status() == QDataStream::Ok && version == layoutVersion && left > 0 && right > 0 &&
                         plane >= 0 && plane <= 3 && layout.columns.cornerFraction > 0.0 &&
                         layout.columns.cornerFraction < 1.0;
    if (!isSound) {
        return std::nullopt;
    }
    layout.columns.leftWidth = left;
    layout.columns.rightWidth = right;
    layout.cornerPlane = plane;
    return layout;
}

}   // namespace angiopose::ui
