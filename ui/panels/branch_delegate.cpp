#include "ui/panels/branch_delegate.h"

#include "ui/panels/branch_model.h"
#include "ui/theme/active_theme.h"
#include "ui/words/number.h"

#include <QLineEdit>
#include <QMouseEvent>
#include <QPainter>

#include <algorithm>

namespace angiopose::ui {
namespace {

constexpr int margin = 14;
constexpr int residualWidth = 44;
constexpr int pillWidth = 40;
constexpr int crossWidth = 20;
constexpr int nameIndent = 20;
constexpr int generationWidth = 32;   // width of "10级", the longest text in any language

void paintBackground(QPainter& painter, const QStyleOptionViewItem& option, const QModelIndex& index)
{
    const Palette& colors = activePalette();
    if (option.state & QStyle::State_Selected) {
        painter.fillRect(option.rect, toQColor(colors.accent, 0.16));
    } else if (index.data(BranchModel::HoveredRole).toBool()) {
        painter.fillRect(option.rect, toQColor(colors.accent, 0.08));
    }
    if (option.state & QStyle::State_HasFocus) {
        painter.fillRect(QRect(option.rect.left(), option.rect.top(), 2, option.rect.height()),
                         toQColor(colors.accent));
    }
}

QColor residualTone(const QModelIndex& index)
{
    const QVariant residual = index.data(BranchModel::ResidualRole);
    const double scaleMm = index.data(BranchModel::ResidualScaleRole).toDouble();
    if (!residual.isValid() || scaleMm <= 0.0) {
        return toQColor(activePalette().hint);
    }
    return toQColor(residualColor(std::clamp(residual.toDouble() / scaleMm, 0.0, 1.0)));
}

/// Darkens the color in the light theme to make it readable as text.
QColor readable(const QColor& tone)
{
    const QColor strong = toQColor(activePalette().textStrong);
    const double fraction = activeTheme() == ThemeMode::Light ? 0.55 : 0.0;
    const auto mix = [fraction](int a, int b) { return static_cast<int>((1.0 - fraction) * a + fraction * b); };
    return {mix(tone.red(), strong.red()), mix(tone.green(), strong.green()), mix(tone.blue(), strong.blue())};
}

void paintChip(QPainter& painter, const QRect& row, const QModelIndex& index)
{
    const QRectF chip(row.left() + margin, row.center().y() - 4.0, 9.0, 9.0);
    const QColor tone = residualTone(index);
    const bool excluded = index.data(BranchModel::ExcludedRole).toBool();
    painter.setPen(QPen(tone, 1.2));
    painter.setBrush(excluded ? QBrush(Qt::NoBrush) : QBrush(tone));
    painter.drawRoundedRect(chip, 2.0, 2.0);
}

void paintPill(QPainter& painter, const QRect& pill, bool on)
{
    const Palette& colors = activePalette();
    painter.setPen(on ? QPen(Qt::NoPen) : QPen(toQColor(colors.line), 1.0));
    painter.setBrush(on ? QBrush(toQColor(colors.accent)) : QBrush(toQColor(colors.field)));
    painter.drawRoundedRect(QRectF(pill).adjusted(0.5, 0.5, -0.5, -0.5), pill.height() / 2.0, pill.height() / 2.0);
    painter.setPen(toQColor(on ? colors.window : colors.hint));
    painter.drawText(pill, Qt::AlignCenter, on ? BranchDelegate::tr("aux") : QStringLiteral("–"));
}

void paintCross(QPainter& painter, const QRect& area, bool excluded)
{
    const Palette& colors = activePalette();
    const QPointF center = QRectF(area).center();
    painter.setPen(QPen(toQColor(excluded ? colors.attention : colors.hint), excluded ? 1.8 : 1.2));
    painter.drawLine(center + QPointF(-3.5, -3.5), center + QPointF(3.5, 3.5));
    painter.drawLine(center + QPointF(-3.5, 3.5), center + QPointF(3.5, -3.5));
}

/// Returns the rectangle of the name, between the color chip and the generation.
QRect nameRectIn(const QStyleOptionViewItem& option, int right)
{
    const int left = option.rect.left() + margin + nameIndent;
    return {left, option.rect.top(), right - left - generationWidth, option.rect.height()};
}

/// Paints the name and, if the full name leaves space, the generation.
void paintName(QPainter& painter, QRect area, const QFont& font, const QModelIndex& index)
{
    const Palette& colors = activePalette();
    const bool excluded = index.data(BranchModel::ExcludedRole).toBool();
    const bool hidden = index.data(BranchModel::HiddenRole).toBool();
    const int generation = index.data(BranchModel::GenerationRole).toInt();
    const QString text = index.data(BranchModel::NameRole).toString();
    QFont name = font;
    name.setWeight(QFont::DemiBold);
    name.setStrikeOut(excluded);
    name.setItalic(hidden);
    painter.setFont(name);
    painter.setPen(toQColor(excluded || hidden ? colors.hint : colors.textStrong));
    const bool hasGeneration = generation >= 0 && QFontMetrics(name).horizontalAdvance(text) < area.width();
    if (!hasGeneration) {
        area.setWidth(area.width() + generationWidth - 4);
    }
    painter.drawText(area, Qt::AlignLeft | Qt::AlignVCenter,
                     QFontMetrics(name).elidedText(text, Qt::ElideMiddle, area.width()));   // keeps trailing numbers
    painter.setFont(font);
    if (hasGeneration) {
        const QRect behind(area.right(), area.top(), generationWidth - 4, area.height());
        painter.setPen(toQColor(colors.hint));
        painter.drawText(behind, Qt::AlignRight | Qt::AlignVCenter, BranchDelegate::tr("g%1").arg(generation));
    }
}

}   // namespace

void BranchDelegate::setEditorData(QWidget* editor, const QModelIndex& index) const
{
    // Prevents updates of marks and residuals from overwriting a name that is being typed.
    const auto* field = qobject_cast<QLineEdit*>(editor);
    if (!field || !field->isModified()) {
        QStyledItemDelegate::setEditorData(editor, index);
    }
}

void BranchDelegate::updateEditorGeometry(QWidget* editor, const QStyleOptionViewItem& option, const QModelIndex&) const
{
    editor->setGeometry(nameRectIn(option, auxiliaryRect(option.rect).left()).adjusted(-6, 1, generationWidth, -1));
}

void BranchDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const
{
    const Palette& colors = activePalette();
    const QRect row = option.rect;
    const bool excluded = index.data(BranchModel::ExcludedRole).toBool();
    const bool auxiliary = index.data(BranchModel::AuxiliaryRole).toBool();
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    paintBackground(*painter, option, index);
    paintChip(*painter, row, index);

    const QRect pill = auxiliaryRect(row);
    const QString length = tr("%1 mm").arg(numberText(index.data(BranchModel::LengthRole).toDouble(), 0));
    const int lengthWidth = option.fontMetrics.horizontalAdvance(length);
    const QRect lengthRect(pill.left() - lengthWidth - 10, row.top(), lengthWidth, row.height());
    const bool hidden = index.data(BranchModel::HiddenRole).toBool();
    const QRect nameRect = nameRectIn(option, lengthRect.left());

    paintName(*painter, nameRect, option.font, index);
    painter->setPen(toQColor(colors.label));
    painter->drawText(lengthRect, Qt::AlignRight | Qt::AlignVCenter, length);
    if (!excluded) {
        paintPill(*painter, pill, auxiliary);
    }
    if (excluded || (option.state & (QStyle::State_MouseOver | QStyle::State_Selected))) {
        paintCross(*painter, excludeRect(row), excluded);
    }
    const QVariant residual = index.data(BranchModel::ResidualRole);
    painter->setPen(readable(residualTone(index)));
    painter->drawText(row.adjusted(0, 0, -margin, 0), Qt::AlignRight | Qt::AlignVCenter,
                      excluded             ? tr("excl.")
                      : hidden             ? tr("hidden")
                      : residual.isValid() ? numberText(residual.toDouble(), 2)
                                           : QString());
    painter->restore();
}

QSize BranchDelegate::sizeHint(const QStyleOptionViewItem& option, const QModelIndex&) const
{
    return {200, std::max(27, option.fontMetrics.height() + 10)};
}

QRect BranchDelegate::excludeRect(const QRect& row)
{
    return {row.right() - margin - residualWidth - crossWidth, row.top(), crossWidth, row.height()};
}

QRect BranchDelegate::auxiliaryRect(const QRect& row)
{
    const int height = std::min(19, row.height() - 4);
    return {excludeRect(row).left() - pillWidth - 2, row.center().y() - height / 2, pillWidth, height};
}

bool BranchDelegate::editorEvent(QEvent* event, QAbstractItemModel*, const QStyleOptionViewItem& option,
                                 const QModelIndex& index)
{
    const auto type = event->type();
    if (type != QEvent::MouseButtonPress && type != QEvent::MouseButtonRelease && type != QEvent::MouseButtonDblClick) {
        return false;
    }
    const auto* mouse = static_cast<QMouseEvent*>(event);
    if (mouse->button() != Qt::LeftButton || mouse->modifiers() != Qt::NoModifier) {
        return false;
    }
    const QPoint place = mouse->position().toPoint();
    const int id = index.data(BranchModel::IdRole).toInt();
    const bool onPill = auxiliaryRect(option.rect).contains(place) && !index.data(BranchModel::ExcludedRole).toBool();
    const bool onCross = excludeRect(option.rect).contains(place);
    if (type == QEvent::MouseButtonRelease && onPill) {
        emit auxiliaryClicked(id);
    } else if (type == QEvent::MouseButtonRelease && onCross) {
        emit excludeClicked(id);
    }
    return onPill || onCross;
}

}   // namespace angiopose::ui
