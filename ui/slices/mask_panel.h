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

/// Depth of a scissors cut: the current slice, a range around it, or all slices.
enum class CutDepth { Slice, Range, Whole };

/// Settings of brush and scissors.
struct MaskSettings {
    double opacity = 0.28;   ///< opacity of the mask on the slices
    double radiusMm = 2.0;   ///< brush radius
    bool is3d = false;   ///< 3-D brush: whether to paint neighboring slices too
    bool isAboveThreshold = false;   ///< whether to paint only voxels above the threshold
    CutDepth depth = CutDepth::Slice;
    double rangeMm = 10.0;   ///< depth of a range cut on each side of the slice

    bool operator==(const MaskSettings&) const = default;
};

/// State of mask editing.
struct MaskState {
    int pendingStrokes = 0;   ///< number of strokes not yet included in the traced vessels
    bool isRunning = false;   ///< true while tracing is running
    bool isEdited = false;   ///< true if the vessels were traced from a manually edited mask
};

/// Panel for the lumen mask on the slices: its opacity, brush and scissors, and tracing of the edited mask. Passive
/// view: displays the given state and emits signals for user actions.
class MaskPanel : public QWidget {
    Q_OBJECT
public:
    explicit MaskPanel(QWidget* parent = nullptr);

    void bind(QAction& paint, QAction& erase, QAction& cut, QAction& trace, QAction& save);
    void showSettings(const MaskSettings& settings);   ///< emits no signal
    void showThreshold(bool hasThreshold);   ///< `hasThreshold` enables painting above the threshold
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
    void updateState();

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
