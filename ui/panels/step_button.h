#pragma once

#include "ui/panels/step_bar.h"
#include "ui/words/retranslation.h"

#include <QAbstractButton>

namespace angiopose::ui {

enum class HintVisibility { Shown, Dropped };

/// Button of one workflow step with mark, name and hint; underlined in the accent color if current.
class StepButton : public QAbstractButton {
    Q_OBJECT
public:
    explicit StepButton(const LocalizedText& name, QWidget* parent = nullptr);

    void showState(const StepState& state);
    void setCurrent(bool current);
    void setHintVisibility(HintVisibility hintVisibility);
    int widthWith(HintVisibility hintVisibility) const;
    QSize sizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    StepState state_;
    HintVisibility hintVisibility_ = HintVisibility::Shown;
    bool current_ = false;
};

}   // namespace angiopose::ui
