#pragma once

#include "ui/controls/section.h"
#include "ui/panels/geometry_values.h"
#include "ui/words/retranslation.h"

#include <QPushButton>

#include <array>

class QComboBox;
class QGridLayout;

namespace angiopose::ui {

/// Distances, spacing, angles, roll, beam center, isocenter and mirroring of the C-arm, each with its origin, and the
/// header values. Values missing from the image can be entered; every edit is reported as a complete C-arm.
class GeometryPanel : public Section {
    Q_OBJECT
public:
    explicit GeometryPanel(QWidget* parent = nullptr);

    void showGeometry(const GeometryState& state);
    void focusFirstMissing();

signals:
    void edited(const core::CArm& cArm, const ui::LocalizedText& undoText);
    void cameraOverrideRemoved();

private:
    struct Row {
        NumberField* field;
        QLabel* origin;
    };
    static QGridLayout* makeGrid();
    void addRow(GeometryValue value, QGridLayout* grid);
    void addDisplaySide(QGridLayout* grid);
    Row& row(GeometryValue value) { return rows_[static_cast<std::size_t>(value)]; }
    void editValue(GeometryValue value, double number);
    void confirmValue(GeometryValue value);
    void assumeMissing();
    void showRow(GeometryValue value);
    void showDisplaySide();
    void showHeader();
    void showNotes();
    QString summary() const;

    GeometryState state_;
    std::array<Row, geometryValueCount> rows_{};
    QComboBox* displaySide_;
    QLabel* displaySideOrigin_;
    Section* advanced_;
    Section* header_;
    QLabel* headerText_;
    QLabel* camera_;
    QLabel* notes_;
    QPushButton* assume_;
    QPushButton* removeOverride_;
    bool wasComplete_ = true;
};

}   // namespace angiopose::ui
