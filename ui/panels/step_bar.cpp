#include "ui/panels/step_bar.h"

#include "ui/panels/step_button.h"

#include <QHBoxLayout>
#include <QStyle>

#include <array>

namespace angiopose::ui {
namespace {

constexpr std::array names{QT_TRANSLATE_NOOP("angiopose::ui::StepBar", "Vessels"),
                           QT_TRANSLATE_NOOP("angiopose::ui::StepBar", "Angiogram"),
                           QT_TRANSLATE_NOOP("angiopose::ui::StepBar", "Geometry"),
                           QT_TRANSLATE_NOOP("angiopose::ui::StepBar", "Initial pose"),
                           QT_TRANSLATE_NOOP("angiopose::ui::StepBar", "Register"),
                           QT_TRANSLATE_NOOP("angiopose::ui::StepBar", "Review"),
                           QT_TRANSLATE_NOOP("angiopose::ui::StepBar", "Export")};

}   // namespace

StepBar::StepBar(QWidget* parent) : QWidget(parent)
{
    setProperty("role", "stepBar");
    setAttribute(Qt::WA_StyledBackground);
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(8, 0, 8, 0);
    layout->setSpacing(4);
    for (int i = 0; i < stepCount; ++i) {
        auto* button = new StepButton([i] { return tr(names[static_cast<std::size_t>(i)]); });
        connect(button, &QAbstractButton::clicked, this, [this, i] { emit stepClicked(static_cast<Step>(i)); });
        layout->addWidget(button);
        buttons_[static_cast<std::size_t>(i)] = button;
    }
    layout->addStretch(1);
    setMinimumWidth(1);
}

void StepBar::showStates(const std::array<StepState, stepCount>& states)
{
    for (std::size_t i = 0; i < states.size(); ++i) {
        buttons_[i]->showState(states[i]);
    }
    fitHints();
}

void StepBar::showCurrent(Step step)
{
    for (int i = 0; i < stepCount; ++i) {
        buttons_[static_cast<std::size_t>(i)]->setCurrent(i == static_cast<int>(step));
    }
}

void StepBar::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    fitHints();
}

void StepBar::fitHints()
{
    // Hides hints one by one, from the right, before a step name is clipped.
    int needed = 16 + 4 * (stepCount - 1);
    for (const StepButton* button : buttons_) {
        needed += button->widthWith(HintVisibility::Shown);
    }
    for (int i = stepCount - 1; i >= 0; --i) {
        StepButton* button = buttons_[static_cast<std::size_t>(i)];
        const bool fits = needed <= width();
        button->setHintVisibility(fits ? HintVisibility::Shown : HintVisibility::Dropped);
        if (!fits) {
            needed -= button->widthWith(HintVisibility::Shown) - button->widthWith(HintVisibility::Dropped);
        }
    }
}

}   // namespace angiopose::ui
