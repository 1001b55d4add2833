#pragma once

#include <QDialog>

#include <functional>

class QLabel;
class QPushButton;

namespace angiopose::ui {

class NumberField;

struct PruneLimits {
    double minLengthMm = 5.0;
    double minRadiusMm = 0.0;
};

/// Dialog for the length and radius below which terminal branches are removed; shows the number of branches affected.
class PruneDialog : public QDialog {
    Q_OBJECT
public:
    /// `countPruned` returns the number of branches that would be removed, or a negative number if none would remain.
    PruneDialog(std::function<int(const PruneLimits&)> countPruned, QWidget* parent = nullptr);

signals:
    void pruneRequested(const ui::PruneLimits& limits);

private:
    void showCount();

    std::function<int(const PruneLimits&)> countPruned_;
    PruneLimits limits_;
    NumberField* length_;
    NumberField* radius_;
    QLabel* count_;
    QPushButton* prune_;
};

}   // namespace angiopose::ui
