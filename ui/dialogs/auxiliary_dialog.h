#pragma once

#include <QDialog>

#include <array>
#include <optional>
#include <vector>

class QGridLayout;
class QLabel;
class QPushButton;

namespace angiopose::ui {

class NumberField;

/// Constraint of one pose parameter: expected standard deviations and the branches that determine it.
struct PinnedStep {
    QString name;   ///< "depth"
    QString unit;
    double stdOfAll = 0.0;   ///< expected 1-σ with all branches …
    double stdOfChosen = 0.0;   ///< … and with the auxiliary branches only
    QString pinnedBy;   ///< branches that constrain it best
};

/// Assessment of the current set of auxiliary branches.
struct AuxiliaryAdvice {
    std::vector<PinnedStep> steps;
    QString suggestion;   ///< names of the suggested branches; empty: none
    QString preview;   ///< branches that the alternation would use now
    QString otherMethod;   ///< method that uses the subset throughout; empty: the current method already does
    int generations = 0;   ///< highest known generation + 1; 0: unknown
    std::optional<double> largestRadiusMm;   ///< empty: the tree has no radii
};

/// Selects the auxiliary branches and shows how well they constrain the pose. Non-modal; displays the values it is
/// given and emits signals for user actions.
class AuxiliaryDialog : public QDialog {
    Q_OBJECT
public:
    explicit AuxiliaryDialog(QWidget* parent);

    void showAdvice(const AuxiliaryAdvice& advice);

signals:
    void generationRequested(int last);   ///< generations 0 … last
    void radiusRequested(double atLeastMm);
    void viewRequested();   ///< branches visible in the view
    void lassoRequested();
    void suggestionRequested();
    void clearRequested();
    void methodRequested();   ///< switches to `otherMethod`

private:
    QLayout* makeWays();
    QWidget* makeTable();

    std::array<std::array<QLabel*, 4>, 6> cells_{};
    QLabel* suggestion_;
    QLabel* preview_;
    NumberField* generation_;
    NumberField* radius_;
    QPushButton* byGeneration_;
    QPushButton* byRadius_;
    QPushButton* take_;
    QPushButton* method_;
};

}   // namespace angiopose::ui