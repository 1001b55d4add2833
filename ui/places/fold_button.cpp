#include "ui/places/fold_button.h"

#include "ui/actions/key_hint.h"
#include "ui/theme/active_theme.h"

#include <QPainter>

namespace angiopose::ui {

FoldButton::FoldButton(ColumnSide side, const Words& folds, QWidget* parent) : QAbstractButton(parent), side_(side)
{
    withName(this, [folds] { return tr("Fold the column: %1").arg(folds()); });
    withTip(this, [side, folds] {
        return tipWithKey(tr("Fold: %1").arg(folds()),
                          side == ColumnSide::Left ? Command::FoldLeft : Command::FoldRight);
    });
    setCursor(Qt::PointingHandCursor);
    setFocusPolicy(Qt::TabFocus);   // a click leaves no mark
    setAttribute(Qt::WA_Hover);
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
}

QSize FoldButton::sizeHint() const
{
    return {9, 56};
}

void FoldButton::paintEvent(QPaintEvent*)
{
    const Palette& tones = activePalette();
    const bool isPointed = underMouse() || hasFocus();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(toQColor(isPointed ? mixed(tones.panel, tones.accent, 0.25) : tones.line));
    painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 3.0, 3.0);
    painter.setPen(
        QPen(toQColor(isPointed ? tones.textStrong : tones.label), 1.4, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    paintChevron(painter, QRectF(rect()).center(), side_);
    if (hasFocus()) {
        painter.setBrush(Qt::NoBrush);
        painter.setPen(toQColor(tones.accent));
        painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 3.0, 3.0);
    }
}

}   // namespace angiopose::ui
