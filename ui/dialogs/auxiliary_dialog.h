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

/// What one step of the pose hangs on.
struct PinnedStep {
    QString name;   ///< "depth"
    QString unit;
    double stdOfAll = 0.0;   ///< expected 1-σ with every branch …
    double stdOfChosen = 0.0;   ///< … and with the chosen ones alone
    QString pinnedBy;   ///< names of the branches that narrow it most
};

/// What is known about the choice of auxiliary branches.
struct AuxiliaryAdvice {
    std::vector<PinnedStep> steps;
    QString suggestion;   ///< names of the suggested branches; empty: none
    QString preview;   ///< what the alternation would use now
    QString otherMethod;   ///< one that uses the choice throughout; empty: the method of the case does
    int generations = 0;   ///< deepest known generation + 1; 0: unknown
    std::optional<double> largestRadiusMm;   ///< nothing: the tree knows no radii
};

/// Ways to choose the auxiliary branches, and what the choice tells about the pose. Stays open beside the window;
/// shows what it is told, reports what the user wants.
class AuxiliaryDialog : public QDialog {
    Q_OBJECT
public:
    explicit AuxiliaryDialog(QWidget* parent);

    void showAdvice(const AuxiliaryAdvice& advice);

signals:
    void generationRequested(int last);   ///< generations 0 … last
    void radiusRequested(double atLeastMm);
    void viewRequested();   ///< the branches in view
    void lassoRequested();
    void suggestionRequested();
    void clearRequested();
    void methodRequested();   ///< the other method

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