#pragma once

#include "core/tracing/angiogram/run/subtract_run.h"
#include "core/tracing/angiogram/trace_angiogram.h"
#include "ui/controls/number_field.h"
#include "ui/controls/section.h"
#include "ui/words/retranslation.h"

class QCheckBox;
class QComboBox;
class QGridLayout;
class QPushButton;

namespace angiopose::ui {

/// Properties of the run that the panel shows.
struct RunState {
    core::RunProcessing processing;
    core::Polarity polarity = core::Polarity::VesselsDark;   ///< polarity in use
    std::vector<int> maskFrames;   ///< mask frames in use, or else the suggested ones; empty if there are none
    bool hasRun = false;   ///< true if the angiogram has more than one frame
    bool isComputing = false;
};

/// Panel for the preprocessing of frames before tracing (mask subtraction, min-IP, interpretation of the pixel values)
/// and for the main tracing options.
class AngiogramPanel : public Section {
    Q_OBJECT
public:
    explicit AngiogramPanel(QWidget* parent = nullptr);

    void showRun(const RunState& state);   ///< emits no signal
    void showWindowLevel(double window, double level);   ///< shows window and level in gray values; emits no signal
    void showTracing(const core::TraceOptions& options,
                     double maxWidthPx);   ///< `maxWidthPx` is the maximum radius in use

signals:
    void windowLevelTyped(double window, double level);
    void treatmentEdited(const core::RunProcessing& processing, const ui::LocalizedText& undoText);
    void pixelShiftRequested();
    void editingRequested();   ///< requests the mode for editing the traced curves
    void tracingEdited(const core::TraceOptions& options, const ui::LocalizedText& undoText);

private:
    void buildBrightness();
    void buildSubtraction();
    void buildPixels();
    void buildTracing();
    void editShift();
    template <class Change>
    void edit(const Change& change, const ui::LocalizedText& undoText);
    NumberField* tracingRow(QGridLayout& grid, int row, const LocalizedText& label, const LocalizedText& help,
                            const NumberFormat& format, double core::TraceOptions::*value);
    NumberField* lengthRow(QGridLayout& grid, int row);

    RunState state_;
    core::TraceOptions tracing_;
    NumberField* window_;
    NumberField* level_;
    QCheckBox* subtract_;
    QCheckBox* composite_;
    ElidedLabel* masks_;
    QPushButton* automaticMasks_;
    NumberField* shiftRight_;
    NumberField* shiftDown_;
    QPushButton* automaticShift_;
    QPushButton* pixelShift_;
    QComboBox* relation_;
    QComboBox* vessels_;
    NumberField* sensitivity_ = nullptr;
    NumberField* length_ = nullptr;
    NumberField* maxRadius_ = nullptr;
    QPushButton* defaults_;
};

}   // namespace angiopose::ui
