#pragma once

#include "ui/panels/step_bar.h"
#include "ui/words/spoken.h"

#include <QAbstractButton>

namespace angiopose::ui {

enum class HintRoom { Shown, Dropped };

/// Button of one workflow step with mark, name and hint; underlined in the accent color if current.
class StepButton : public QAbstractButton {
    Q_OBJECT
public:
    explicit StepButton(const Words& name, QWidget* parent = nullptr);

    void showState(const StepState& state);
    void setCurrent(bool current);
    void setHintRoom(HintRoom room);
    int widthWith(HintRoom room) const;
    QSize sizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    StepState state_;
    HintRoom room_ = HintRoom::Shown;
    bool current_ = false;
};

}   // namespace angiopose::ui
