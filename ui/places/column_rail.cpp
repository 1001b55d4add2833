#include "ui/places/column_rail.h"

#include "ui/actions/key_hint.h"
#include "ui/theme/active_theme.h"

#include <QPainter>

namespace angiopose::ui {
namespace {

constexpr int railWidth = 30;
constexpr int chevronFromTop = 22;
constexpr int wordsFromTop = 42;

Command commandOf(ColumnSide side)
{
    return side == ColumnSide::Left ? Command::FoldLeft : Command::FoldRight;
}

}   // namespace

void paintChevron(QPainter& painter, const QPointF& at, ColumnSide side)
{
    const double way = side == ColumnSide::Left ? -1.0 : 1.0;
    painter.drawPolyline(
        QPolygonF({at + QPointF(-2.0 * way, -4.5), at + QPointF(2.0 * way, 0.0), at + QPointF(-2.0 * way, 4.5)}));
}

ColumnRail::ColumnRail(ColumnSide side, const Words& behind, QWidget* parent) : QAbstractButton(parent), side_(side)
{
    withText(this, behind);
    withName(this, [behind] { return tr("Unfold the column: %1").arg(behind()); });
    withTip(this, [side, behind] { return tipWithKey(tr("Unfold: %1").arg(behind()), commandOf(side)); });
    setCursor(Qt::PointingHandCursor);
    setFocusPolicy(Qt::TabFocus);   // a click leaves no mark
    setAttribute(Qt::WA_Hover);
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Expanding);
}

QSize ColumnRail::sizeHint() const
{
    return {railWidth, 320};
}

int ColumnRail::wordsRoomPx(int height)
{
    return height - wordsFromTop - 8;
}

/// The words run as on the back of a book, towards the image.
void ColumnRail::paintEvent(QPaintEvent*)
{
    const Palette& tones = activePalette();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(rect(), toQColor(underMouse() ? mixed(tones.panel, tones.accent, 0.10) : tones.panel));
    const QColor tone = toQColor(underMouse() || hasFocus() ? tones.textStrong : tones.label);
    painter.setPen(QPen(tone, 1.6, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    paintChevron(painter, {0.5 * width(), chevronFromTop},
                 side_ == ColumnSide::Left ? ColumnSide::Right : ColumnSide::Left);
    const int room = wordsRoomPx(height());
    painter.save();
    painter.translate(0.5 * width(), wordsFromTop);
    painter.rotate(90.0);
    painter.drawText(QRect(0, -width() / 2, room, width()), Qt::AlignLeft | Qt::AlignVCenter,
                     painter.fontMetrics().elidedText(text(), Qt::ElideRight, room));
    painter.restore();
    if (hasFocus()) {
        painter.setRenderHint(QPainter::Antialiasing, false);
        painter.setPen(toQColor(tones.accent));
        painter.drawRect(rect().adjusted(0, 0, -1, -1));
    }
}

}   // namespace angiopose::ui
