#pragma once

#include "core/measuring/branch_profile.h"
#include "ui/controls/section.h"

#include <array>

class QLabel;
class QPushButton;

namespace angiopose::ui {

class ProfilePlot;

/// Measurements along one branch: its values, their limitations, and its profile.
class ProfilePanel : public Section {
    Q_OBJECT
public:
    explicit ProfilePanel(QWidget* parent = nullptr);

    void showProfile(const core::VesselBranch& branch, const core::BranchProfile& profile);
    void showNothing(const QString& why, bool hasBranches);   ///< `hasBranches`: a table can be exported
    ProfilePlot& plot() { return *plot_; }

signals:
    void tableRequested();   ///< table of all branches
    void profileRequested();   ///< profile of the shown branch

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

/// Formats a stenosis: "63 % at 24.5 mm (1.30 of 3.50 mm, 8.5 mm long)".
QString stenosisWords(const core::StenosisMeasure& stenosis);

}   // namespace angiopose::ui
