#pragma once

#include <QWidget>

#include <array>

class QHBoxLayout;

namespace angiopose::ui {

/// The way through a case, in order.
enum class Step { Vessels, Angiogram, Geometry, StartPose, Register, Review, Export };
inline constexpr int stepCount = 7;

enum class StepMark { Open, Done, Look };

/// What one step says: its mark, and a few words that are true right now.
struct StepState {
    StepMark mark = StepMark::Open;
    QString hint;
    QString whyNotReady;   ///< shown as tool tip

    bool operator==(const StepState&) const = default;
};

class StepButton;

/// The steps in a row, each with a tick or an exclamation mark; freely clickable.
class StepBar : public QWidget {
    Q_OBJECT
public:
    explicit StepBar(QWidget* parent = nullptr);

    void showStates(const std::array<StepState, stepCount>& states);
    void showCurrent(Step step);

signals:
    void stepClicked(ui::Step step);

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void fitHints();

    std::array<StepButton*, stepCount> buttons_{};
};

}   // namespace angiopose::ui