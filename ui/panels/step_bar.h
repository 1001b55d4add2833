#pragma once

#include <QWidget>

#include <array>

class QHBoxLayout;

namespace angiopose::ui {

/// Workflow steps of a case, in order.
enum class Step { Vessels, Angiogram, Geometry, InitialPose, Register, Review, Export };
inline constexpr int stepCount = 7;

enum class StepMark { Open, Done, Look };

/// State of one step: its mark and a short hint about the current situation.
struct StepState {
    StepMark mark = StepMark::Open;
    QString hint;
    QString whyNotReady;   ///< shown as tooltip

    bool operator==(const StepState&) const = default;
};

class StepButton;

/// Workflow steps in a row, each with a check mark or an exclamation mark; all are clickable.
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