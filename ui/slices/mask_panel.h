#pragma once

#include <QWidget>

#include <array>

class QAction;
class QCheckBox;
class QComboBox;
class QLabel;
class QPushButton;
class QSlider;

namespace angiopose::ui {

class NumberField;

/// How far through the slices scissors cut.
enum class CutDepth { Slice, Range, Whole };

/// Settings of the brush and the scissors.
struct MaskSettings {
    double opacity = 0.28;   ///< of the mask over the slices
    double radiusMm = 2.0;   ///< of the brush
    bool isBall = false;   ///< through the slices beside, too
    bool isAboveThreshold = false;   ///< paints no darker voxels
    CutDepth depth = CutDepth::Slice;
    double rangeMm = 10.0;   ///< before and behind the slice

    bool operator==(const MaskSettings&) const = default;
};

/// What is to be said of the mask.
struct MaskState {
    int openStrokes = 0;   ///< that the vessels do not know yet
    bool isRunning = false;   ///< they are being traced
    bool isEdited = false;   ///< the vessels come from a mask edited by hand
};

/// The lumen mask over the slices: how strong it is shown, brush and scissors, and tracing what was edited. Shows what
/// it is told, reports what the user wants.
class MaskPanel : public QWidget {
    Q_OBJECT
public:
    explicit MaskPanel(QWidget* parent = nullptr);

    void bind(QAction& paint, QAction& erase, QAction& cut, QAction& trace, QAction& save);
    void showSettings(const MaskSettings& settings);   ///< silent
    void showThreshold(bool isThere);   ///< without one nothing is above it
    void showState(const MaskState& state);

signals:
    void settingsEdited(const ui::MaskSettings& settings);

private:
    QLayout* opacityRow();
    QLayout* toolRow();
    QLayout* brushRows();
    QLayout* cutRow();
    void connectParts();
    void edit();
    void sayState();

    MaskSettings settings_;
    MaskState state_;
    QSlider* opacity_;
    std::array<QPushButton*, 3> tools_;
    NumberField* radius_;
    QCheckBox* ball_;
    QCheckBox* above_;
    QComboBox* depth_;
    NumberField* range_;
    QPushButton* trace_;
    QPushButton* save_;
    QLabel* note_;
};

}   // namespace angiopose::ui
