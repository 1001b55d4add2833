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

/// Constraint on one pose parameter: expected standard deviations, and the branches that constrain it best.
struct ParameterConstraint {
    QString name;   ///< e.g. "depth"
    QString unit;
    double stdAllBranches = 0.0;   ///< expected standard deviation with all branches
    double stdAuxiliary = 0.0;   ///< expected standard deviation with the auxiliary branches only
    QString constrainedBy;   ///< branches that constrain this parameter best
};

/// Assessment of the current set of auxiliary branches.
struct AuxiliaryAdvice {
    std::vector<ParameterConstraint> steps;
    QString suggestion;   ///< names of the suggested branches; empty if there is no suggestion
    QString preview;   ///< branches that the alternating method would use now
    QString otherMethod;   ///< method that uses only the auxiliary branches throughout; empty if already selected
    int generations = 0;   ///< highest known generation + 1; 0 if unknown
    std::optional<double> maxRadiusMm;   ///< nullopt if the tree has no radii
};

/// Dialog that selects the auxiliary branches and shows how well they constrain the pose. Non-modal passive view:
/// displays the given state and emits signals for user actions.
class AuxiliaryDialog : public QDialog {
    Q_OBJECT
public:
    explicit AuxiliaryDialog(QWidget* parent);

    void showAdvice(const AuxiliaryAdvice& advice);

signals:
    void generationRequested(int last);   ///< requests generations 0 to `last`
    void radiusRequested(double atLeastMm);
    void viewRequested();   ///< requests the branches visible in the view
    void lassoRequested();
    void suggestionRequested();
    void clearRequested();
    void methodRequested();   ///< requests a switch to `otherMethod`

private:
    QLayout* makeSelectors();
    QWidget* makeTable();

    std::array<std::array<QLabel*, 4>, 6> cells_{};
    QLabel* suggestion_;
    QLabel* preview_;
    NumberField* generation_;
    NumberField* radius_;
    QPushButton* byGeneration_;
    QPushButton* byRadius_;
    QPushButton* apply_;
    QPushButton* method_;
};

}   // namespace angiopose::ui
