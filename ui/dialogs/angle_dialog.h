#pragma once

#include "core/geometry/sight.h"
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

/// The vessels as the detector would show them, as wide as they are, what is looked at in the accent.
class SimulatedView : public QWidget {
    Q_OBJECT
public:
    explicit SimulatedView(QWidget* parent = nullptr);

    /// No sight: nothing to show yet.
    void showVessels(std::shared_ptr<const core::VesselTree> tree, int branchId,
                     const std::optional<core::Sight>& sight);
    QSize sizeHint() const override { return {230, 230}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    void paintBranch(QPainter& painter, const core::VesselBranch& branch, double scale) const;

    std::shared_ptr<const core::VesselTree> tree_;
    int branchId_ = 0;
    std::optional<core::Sight> sight_;
};

class AngleMapPlot;
class NumberField;
class SimulatedView;

/// What the gantry reaches.
struct GantryReach {
    core::AngleRange primary;
    core::AngleRange secondary;
};

/// Which C-arm angles show a branch: the map, the best angles, and what would be seen from those that are picked.
/// Stays open beside the window; shows what it is told, reports what the user wants.
class AngleDialog : public QDialog {
    Q_OBJECT
public:
    AngleDialog(const GantryReach& reach, QWidget* parent);

    void showBranch(const QString& title, const QString& hint);   ///< what is looked at, and what to know of it
    void showMap(const std::optional<core::AngleMap>& map, const std::optional<core::AngleSuggestion>& now);
    void showPicked(const core::AngleSuggestion& picked);
    void showVessels(std::shared_ptr<const core::VesselTree> tree, int branchId,
                     const std::optional<core::Sight>& sight);

    bool isTakeOff() const;
    GantryReach reach() const;

signals:
    void questionChanged();   ///< take-off or reach
    void picked(const core::GantryAngles& angles);

private:
    QLayout* makeReach(const GantryReach& reach);
    QLayout* makeBest();

    QLabel* title_;
    QLabel* hint_;
    QCheckBox* takeOff_;
    AngleMapPlot* plot_;
    SimulatedView* view_;
    QLabel* picked_;
    QPushButton* now_;
    std::array<QPushButton*, 3> best_{};
    std::array<NumberField*, 4> reach_{};   ///< RAO, LAO, CAU, CRA
    std::optional<core::AngleSuggestion> nowAt_;
    std::optional<core::AngleMap> map_;
};

}   // namespace angiopose::ui
