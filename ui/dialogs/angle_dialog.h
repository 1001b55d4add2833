#pragma once

#include "core/geometry/posed_camera.h"
#include "core/vessel/vessel_tree.h"
#include "core/viewing/angle_map.h"

#include <QDialog>
#include <QWidget>
#include <array>
#include <memory>
#include <optional>

class QCheckBox;
class QLabel;
class QPushButton;

namespace angiopose::ui {

/// Simulated view of the vessels on the detector at their true width, with the target branch in the accent color.
class SimulatedView : public QWidget {
    Q_OBJECT
public:
    explicit SimulatedView(QWidget* parent = nullptr);

    /// Shows the vessels; leaves the view empty if there is no camera and pose.
    void showVessels(std::shared_ptr<const core::VesselTree> tree, int branchId,
                     const std::optional<core::PosedCamera>& sight);
    QSize sizeHint() const override { return {230, 230}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    void paintBranch(QPainter& painter, const core::VesselBranch& branch, double scale) const;

    std::shared_ptr<const core::VesselTree> tree_;
    int branchId_ = 0;
    std::optional<core::PosedCamera> posedCamera_;
};

class AngleMapPlot;
class NumberField;
class SimulatedView;

/// Gantry angle limits.
struct GantryLimits {
    core::AngleRange primary;
    core::AngleRange secondary;
};

/// Dialog that finds C-arm angles at which a branch is well visible: angle map, best angles and a simulated view at the
/// selected angles. Non-modal passive view: displays the given state and emits signals for user actions.
class AngleDialog : public QDialog {
    Q_OBJECT
public:
    AngleDialog(const GantryLimits& limits, QWidget* parent);

    void showBranch(const QString& title, const QString& hint);   ///< shows the target branch and notes about it
    void showMap(const std::optional<core::AngleMap>& map, const std::optional<core::AngleSuggestion>& current);
    void showPicked(const core::AngleSuggestion& picked);
    void showVessels(std::shared_ptr<const core::VesselTree> tree, int branchId,
                     const std::optional<core::PosedCamera>& sight);

    bool isTakeOff() const;
    GantryLimits limits() const;

signals:
    void criteriaChanged();   ///< emitted when the origin-only option or the gantry limits have changed
    void picked(const core::GantryAngles& angles);

private:
    QLayout* makeLimitFields(const GantryLimits& limits);
    QLayout* makeBestButtons();

    QLabel* title_;
    QLabel* hint_;
    QCheckBox* originOnly_;
    AngleMapPlot* plot_;
    SimulatedView* view_;
    QLabel* picked_;
    QPushButton* currentButton_;
    std::array<QPushButton*, 3> best_{};
    std::array<NumberField*, 4> limits_{};   ///< limits of RAO, LAO, CAU, CRA
    std::optional<core::AngleSuggestion> currentAngles_;
    std::optional<core::AngleMap> map_;
};

}   // namespace angiopose::ui
