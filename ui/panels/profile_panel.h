#pragma once

#include "core/measuring/branch_profile.h"
#include "ui/controls/section.h"

#include <array>

class QLabel;
class QPushButton;

namespace angiopose::ui {

class ProfilePlot;

/// Panel with the measurements along one branch: values, their limitations, and the profile plot.
class ProfilePanel : public Section {
    Q_OBJECT
public:
    explicit ProfilePanel(QWidget* parent = nullptr);

    void showProfile(const core::VesselBranch& branch, const core::BranchProfile& profile);
    void showNothing(const QString& why, bool hasBranches);   ///< `hasBranches` enables exporting the table
    ProfilePlot& plot() { return *plot_; }

signals:
    void tableExportRequested();   ///< requests the table of all branches
    void profileExportRequested();   ///< requests the profile of the displayed branch

private:
    QWidget* makeNumbers();

    enum Number { Length, Diameter, MinDiameter, Stenosis, Tortuosity, Curvature, NumberCount };
    std::array<QLabel*, NumberCount> numbers_{};
    QWidget* grid_;
    QLabel* warning_;
    ProfilePlot* plot_;
    QPushButton* table_;
    QPushButton* profile_;
};

/// Formats a stenosis, e.g. "63 % at 24.5 mm (1.30 of 3.50 mm, 8.5 mm long)".
QString stenosisText(const core::StenosisMeasure& stenosis);

}   // namespace angiopose::ui
