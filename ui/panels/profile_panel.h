#pragma once

#include "core/measuring/branch_profile.h"
#include "ui/controls/section.h"

#include <array>

class QLabel;
class QPushButton;

namespace angiopose::ui {

class ProfilePlot;

/// Measures along one branch: its numbers, what is not known, and its profile.
class ProfilePanel : public Section {
    Q_OBJECT
public:
    explicit ProfilePanel(QWidget* parent = nullptr);

    void showProfile(const core::VesselBranch& branch, const core::BranchProfile& profile);
    void showNothing(const QString& why, bool hasBranches);   ///< `hasBranches`: a table of them can be written
    ProfilePlot& plot() { return *plot_; }

signals:
    void tableRequested();   ///< of all branches
    void profileRequested();   ///< of the branch that is shown

private:
    QWidget* makeNumbers();

    enum Number { Length, Diameter, MinDiameter, Stenosis, Tortuosity, Curvature, NumberCount };
    std::array<QLabel*, NumberCount> numbers_{};
    QWidget* grid_;
    QLabel* doubt_;
    ProfilePlot* plot_;
    QPushButton* table_;
    QPushButton* profile_;
};

/// "63 % at 24.5 mm (1.30 of 3.50 mm, 8.5 mm long)".
QString narrowingWords(const core::Narrowing& narrowing);

}   // namespace angiopose::ui
