#include "tests/app/gallery/clipped_texts.h"

#include "ui/controls/section.h"
#include "ui/places/folding_column.h"

#include <QAbstractButton>
#include <QAbstractScrollArea>
#include <QCheckBox>
#include <QComboBox>
#include <QFontMetrics>
#include <QLabel>
#include <QLineEdit>
#include <QStyle>
#include <QStyleOptionComboBox>
#include <QToolButton>

namespace angiopose::test {
namespace {

constexpr int tolerancePx = 1;

QString described(const QWidget& widget, const QString& text, int has, int needs)
{
    return QStringLiteral("%1 “%2” has %3 px and needs %4")
        .arg(QString::fromLatin1(widget.metaObject()->className()), text.simplified())
        .arg(has)
        .arg(needs);
}

int widthOf(const QWidget& widget, const QString& text)
{
    int widest = 0;
    for (const QString& line : text.split(QLatin1Char('\n'))) {
        widest = std::max(widest, widget.fontMetrics().size(Qt::TextShowMnemonic, line).width());
    }
    return widest;
}

QString problemOf(const QLabel& label)
{
    if (label.text().isEmpty() || qobject_cast<const ui::ElidedLabel*>(&label)) {
        return {};
    }
    if (label.wordWrap()) {
        const int needed = label.heightForWidth(label.width());
        return needed > label.height() + tolerancePx ? described(label, label.text(), label.height(), needed)
                                                     : QString();
    }
    const int needed = label.sizeHint().width();
    return needed > label.width() + tolerancePx ? described(label, label.text(), label.width(), needed) : QString();
}

/// True for an icon-only button, whose text appears only in its tooltip.
bool isSign(const QAbstractButton& button)
{
    const auto* tool = qobject_cast<const QToolButton*>(&button);
    return tool && tool->toolButtonStyle() == Qt::ToolButtonIconOnly && !tool->icon().isNull();
}

QString problemOf(const QAbstractButton& button)
{
    if (button.text().isEmpty() || isSign(button)) {
        return {};
    }
    if (qobject_cast<const ui::ColumnRail*>(&button)) {   // its text is vertical
        const int room = ui::ColumnRail::maxTextLengthPx(button.height());
        const int length = widthOf(button, button.text());
        return length > room ? described(button, button.text(), room, length) : QString();
    }
    const int mark = qobject_cast<const QCheckBox*>(&button) ? 20 : 0;
    const int needed = widthOf(button, button.text()) + mark + 4;
    return needed > button.width() ? described(button, button.text(), button.width(), needed) : QString();
}

QString problemOf(const QComboBox& box)
{
    QStyleOptionComboBox option;
    option.initFrom(&box);
    const int has =
        box.style()->subControlRect(QStyle::CC_ComboBox, &option, QStyle::SC_ComboBoxEditField, &box).width();
    const int needed = widthOf(box, box.currentText());
    return needed > has + tolerancePx ? described(box, box.currentText(), has, needed) : QString();
}

QString problemOf(const QLineEdit& field)
{
    const QString words = field.text().isEmpty() ? field.placeholderText() : field.text();
    const int has = field.width() - field.textMargins().left() - field.textMargins().right() - 8;
    const int needed = widthOf(field, words);
    return needed > has ? described(field, words, has, needed) : QString();
}

/// Describes a widget that its parent clips without offering a way to scroll.
QString cutOff(const QWidget& widget)
{
    const QWidget* parent = widget.parentWidget();
    const bool scrolls = parent && qobject_cast<const QAbstractScrollArea*>(parent->parentWidget());
    if (!parent || widget.isWindow() || scrolls || parent->rect().adjusted(-1, -1, 1, 1).contains(widget.geometry())) {
        return {};
    }
    return QStringLiteral("%1 reaches out of its %2")
        .arg(QString::fromLatin1(widget.metaObject()->className()),
             QString::fromLatin1(parent->metaObject()->className()));
}

QString problemOf(const QWidget& widget)
{
    if (const auto* label = qobject_cast<const QLabel*>(&widget)) {
        return problemOf(*label);
    }
    if (const auto* button = qobject_cast<const QAbstractButton*>(&widget)) {
        return problemOf(*button);
    }
    if (const auto* box = qobject_cast<const QComboBox*>(&widget)) {
        return problemOf(*box);
    }
    if (const auto* field = qobject_cast<const QLineEdit*>(&widget)) {
        return problemOf(*field);
    }
    return {};
}

}   // namespace

QStringList clippedTexts(const QWidget& root)
{
    QStringList problems;
    for (const QWidget* widget : root.findChildren<QWidget*>()) {
        if (!widget->isVisible() || widget->window() != root.window() ||
            widget->objectName().startsWith(QLatin1String("qt_"))) {
            continue;
        }
        for (const QString& problem : {problemOf(*widget), cutOff(*widget)}) {
            if (!problem.isEmpty()) {
                problems << problem;
            }
        }
    }
    return problems;
}

}   // namespace angiopose::test
