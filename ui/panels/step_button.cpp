#include "ui/panels/step_button.h"

#include "ui/theme/active_theme.h"

#include <QPainter>

namespace angiopose::ui {
namespace {

constexpr int sideMargin = 14;
constexpr int markWidth = 20;
constexpr int hintGap = 8;

QFont hintFont(QFont font)
{
    font.setPixelSize(std::max(10, font.pixelSize() - 1));
    return font;
}

QFont nameFont(QFont font, QFont::Weight weight)
{
    font.setWeight(weight);
    return font;
}

QString glyphOf(StepMark mark)
{
    switch (mark) {
        case StepMark::Done:
            return QStringLiteral("✓");
        case StepMark::Attention:
            return QStringLiteral("!");
        case StepMark::Open:
            break;
    }
    return {};
}

}   // namespace

StepButton::StepButton(const LocalizedText& name, QWidget* parent) : QAbstractButton(parent)
{
    withText(this, name);
    setCursor(Qt::PointingHandCursor);
    setFocusPolicy(Qt::TabFocus);
    setFixedHeight(40);
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
}

void StepButton::showState(const StepState& state)
{
    state_ = state;
    setToolTip(state.whyNotReady);
    const QString spoken = state.mark == StepMark::Done        ? tr("done")
                           : state.mark == StepMark::Attention ? tr("check")
                                                               : tr("to do");
    setAccessibleName(tr("%1: %2, %3").arg(text(), spoken, state.hint));
    updateGeometry();
    update();
}

void StepButton::setCurrent(bool current)
{
    current_ = current;
    update();
}

void StepButton::setHintVisibility(HintVisibility hintVisibility)
{
    hintVisibility_ = hintVisibility;
    updateGeometry();
    update();
}

int StepButton::widthWith(HintVisibility hintVisibility) const
{
    // The current step has a bold name; reserving its width for every step keeps the layout stable.
    const QFontMetrics nameMetrics(nameFont(font(), QFont::DemiBold));
    int width = 2 * sideMargin + nameMetrics.horizontalAdvance(text());
    if (state_.mark != StepMark::Open) {
        width += markWidth;
    }
    if (hintVisibility == HintVisibility::Shown && !state_.hint.isEmpty()) {
        width += hintGap + QFontMetrics(hintFont(font())).horizontalAdvance(state_.hint);
    }
    return width;
}

QSize StepButton::sizeHint() const
{
    return {widthWith(hintVisibility_), 40};
}

void StepButton::paintEvent(QPaintEvent*)
{
    const Palette& colors = activePalette();
    QPainter painter(this);
    if (underMouse()) {
        painter.fillRect(rect(), toQColor(colors.accent, 0.06));
    }
    int x = sideMargin;
    const auto write = [&](const QString& words, const Color& tone) {
        painter.setPen(toQColor(tone));
        painter.drawText(QRect(x, 0, width(), height()), Qt::AlignLeft | Qt::AlignVCenter, words);
    };
    if (state_.mark != StepMark::Open) {
        QFont bold = font();
        bold.setWeight(QFont::Bold);
        painter.setFont(bold);
        write(glyphOf(state_.mark), state_.mark == StepMark::Done ? colors.fine : colors.attention);
        painter.setFont(font());
        x += markWidth;
    }
    painter.setFont(nameFont(font(), current_ ? QFont::DemiBold : QFont::Normal));
    write(text(), current_ ? colors.textStrong : colors.text);
    x += painter.fontMetrics().horizontalAdvance(text()) + hintGap;
    if (hintVisibility_ == HintVisibility::Shown) {
        painter.setFont(hintFont(font()));
        write(state_.hint, colors.hint);
    }
    if (current_) {
        painter.fillRect(QRect(0, height() - 2, width(), 2), toQColor(colors.accent));
    }
    if (hasFocus()) {
        painter.setPen(QPen(toQColor(colors.accent), 1.0));
        painter.drawRect(rect().adjusted(1, 1, -2, -4));
    }
}

}   // namespace angiopose::ui
