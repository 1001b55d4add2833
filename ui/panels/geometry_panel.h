#pragma once

#include "core/geometry/c_arm.h"
#include "ui/panels/number_field.h"
#include "ui/panels/section.h"

#include <QPushButton>

#include <array>

namespace ui {

/// What the geometry panel shows.
struct GeometryState {
    core::CArm cArm;
    std::optional<core::ProjectionCamera> cameraOverride;   ///< of the case file; wins over distances and spacing
    std::optional<double> vesselMmPerPx;   ///< scale at the vessels, when there is a pose
    std::vector<std::string> contradictions;
    QString missing;   ///< what keeps the camera from being known; empty when nothing
};

/// Distances, spacing and angles of the C-arm, each with where it comes from. Values the image did not bring can be
/// typed; every edit is reported as a whole C-arm.
class GeometryPanel : public Section {
    Q_OBJECT
public:
    explicit GeometryPanel(QWidget* parent = nullptr);

    void showGeometry(const GeometryState& state);
    void focusFirstMissing();

signals:
    void edited(const core::CArm& cArm, const QString& what);
    void cameraOverrideDropped();

private:
    enum Value { Sid, Sod, Spacing, Primary, Secondary, ValueCount };
    struct Row {
        NumberField* field;
        QLabel* origin;
    };
    Row makeRow(Value value);
    static core::Sourced<double>& valueIn(core::CArm& cArm, Value value);
    void editValue(Value value, double number);
    void assumeMissing();
    void showRow(Value value);
    void showNotes(const GeometryState& state);
    QString summary(const GeometryState& state) const;

    core::CArm cArm_;
    std::array<Row, ValueCount> rows_{};
    QLabel* camera_;
    QLabel* notes_;
    QPushButton* assume_;
    QPushButton* dropOverride_;
    bool wasComplete_ = true;
};

}   // namespace ui
