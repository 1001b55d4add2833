#pragma once

#include "core/geometry/image_measurement.h"
#include "ui/controls/section.h"

#include <QPushButton>

#include <array>
#include <optional>
#include <set>
#include <vector>

class QAction;
class QComboBox;
class QDoubleSpinBox;
class QTreeWidget;

namespace angiopose::ui {

/// A measurement as it is listed.
struct MeasureRow {
    QString name;   ///< as the user named it, or what it is
    QString value;   ///< or why there is none
    QString basis;   ///< what the value rests on, sentences
    bool isDoubtful = false;   ///< no value, or one on assumed ground
};

/// What the measure panel shows.
struct MeasureState {
    std::vector<MeasureRow> rows;
    core::MeasurementPlane plane = core::MeasurementPlane::Vessels;   ///< for the chosen ones, or for the next
    QString basis;   ///< of the plane
    std::optional<double> typedMmPerPx;
};

/// Measurements in the image and in slices: where those of the image are taken to lie, the modes that draw them, and
/// the list, in which they are chosen, renamed and removed.
class MeasurePanel : public Section {
    Q_OBJECT
public:
    explicit MeasurePanel(QWidget* parent = nullptr);

    void showMeasurements(const MeasureState& state);   ///< silent, keeps what is chosen
    void bindMode(core::MeasurementKind kind, QAction& action);
    std::set<int> chosen() const;   ///< places in the list

signals:
    void planePicked(core::MeasurementPlane plane);
    void scaleTyped(double mmPerPx);   ///< 0: none
    void choiceChanged();   ///< `chosen`
    void renamed(int place, const QString& name);
    void removeRequested(const std::set<int>& places);
    void exportRequested();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void setUpList();
    void connectParts();
    void showBasis();
    void removeChosen();

    QComboBox* plane_;
    QDoubleSpinBox* scale_;
    QTreeWidget* list_;
    QLabel* basis_;
    std::array<QPushButton*, 3> modes_;   ///< by core::MeasurementKind
    QPushButton* remove_;
    QPushButton* export_;
    MeasureState state_;
    bool showing_ = false;   ///< true while the owner, not the user, changes the list
};

}   // namespace angiopose::ui
