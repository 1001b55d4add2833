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

/// Row of the measurement list.
struct MeasureRow {
    QString name;   ///< user-defined name, or the type of the measurement
    QString value;   ///< measured value, or the reason why it is missing
    QString basis;   ///< how the value was obtained, in full sentences
    bool isDoubtful = false;   ///< true if the value is missing or based on assumptions
};

/// Values shown by the measurement panel.
struct MeasureState {
    std::vector<MeasureRow> rows;
    core::MeasurementPlane plane = core::MeasurementPlane::Vessels;   ///< plane of the selected or the next measurement
    QString basis;   ///< explanation of the plane
    std::optional<double> enteredMmPerPx;
};

/// Panel for measurements in the angiogram and in slices: the plane assumed for the angiogram, buttons for the drawing
/// modes, and a list to select, rename and remove measurements.
class MeasurePanel : public Section {
    Q_OBJECT
public:
    explicit MeasurePanel(QWidget* parent = nullptr);

    void showMeasurements(const MeasureState& state);   ///< emits no signal, keeps the selection
    void bindMode(core::MeasurementKind kind, QAction& action);
    std::set<int> selectedRows() const;   ///< indices of the selected rows

signals:
    void planePicked(core::MeasurementPlane plane);
    void scaleTyped(double mmPerPx);   ///< emitted with 0 if the user cleared the scale
    void selectionChanged();   ///< emitted when the selection has changed; see `chosen`
    void renamed(int place, const QString& name);
    void removeRequested(const std::set<int>& rowIndices);
    void exportRequested();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void setUpList();
    void connectParts();
    void showBasis();
    void removeSelected();

    QComboBox* plane_;
    QDoubleSpinBox* scale_;
    QTreeWidget* list_;
    QLabel* basis_;
    std::array<QPushButton*, 3> modes_;   ///< indexed by core::MeasurementKind
    QPushButton* remove_;
    QPushButton* export_;
    MeasureState state_;
    bool isUpdating_ = false;   ///< true while the program, not the user, changes the list
};

}   // namespace angiopose::ui
