#pragma once

#include <QWidget>

#include <array>

class QHBoxLayout;

namespace angiopose::ui {

/// Workflow steps of a case, in order.
enum class Step { Vessels, Angiogram, Geometry, InitialPose, Register, Review, Export };
inline constexpr int stepCount = 7;

enum class StepMark { Open, Done, Attention };

/// State of a workflow step: its mark, and a short hint about what has been done or is missing.
struct StepState {
    StepMark mark = StepMark::Open;
    QString hint;
    QString whyNotReady;   ///< tooltip that states why the step is not ready

    bool operator==(const StepState&) const = default;
};

class StepButton;

/// Bar with the workflow steps, each with a check mark or an exclamation mark; every step can be clicked.
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
