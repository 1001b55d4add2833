#pragma once

#include "core/tracing/volume/vessel_input.h"
#include "ui/controls/section.h"
#include "ui/slices/seed_list.h"

#include <optional>

class QAction;
class QCheckBox;
class QComboBox;
class QPushButton;

namespace angiopose::ui {

class LabelChoice;
class MaskPanel;
class NumberField;
class ThresholdField;

/// Panel with the options for tracing the vessels of a scan: threshold, seeds, avoid points, limits. Passive view:
/// displays the given state and emits signals for user actions.
class TracingPanel : public Section {
    Q_OBJECT
public:
    explicit TracingPanel(QWidget* parent = nullptr);

    void showOptions(const core::VesselTracingOptions& options);   ///< emits no signal
    /// Sets the range of the threshold; without a value, the input has no intensities (labels, surface).
    void showRange(std::optional<std::pair<double, double>> range, bool isHounsfield = true);
    LabelChoice& labels() { return *labels_; }
    MaskPanel& mask() { return *mask_; }
    void bindPath(QAction& action);   ///< connects the action for tracing between two clicks
    void showAutomatic(std::optional<double> threshold);   ///< shows the automatic threshold, if known
    void showPick(TracingPick pick);
    void showFalseLumen(const QString& warning);   ///< an empty string hides the warning
    void showBlockingReason(const QString& reason);   ///< reason why tracing is disabled; if empty, tracing is enabled
    void setRunning(bool running);
    bool isPreviewWanted() const;
    std::optional<double> thresholdShown() const;   ///< threshold in use, manual or automatic

signals:
    void optionsEdited(const core::VesselTracingOptions& options);
    void pickRequested(ui::TracingPick pick);
    void previewChanged();
    void pointSelected(const Eigen::Vector3d& pointInPatient);
    void traceRequested();
    void stopRequested();
    void falseLumenRequested();   ///< requests showing the possible false lumen
    void falseLumenSeedRequested();

private:
    QWidget* makeLumenWarning();
    QLayout* seedRows();
    QLayout* limitRows();
    QLayout* shapeRows();
    QLayout* buttonRow();
    void reportThreshold();
    void updateButtons();

    core::VesselTracingOptions options_;
    QString blockingReason_;
    bool running_ = false;
    bool hasValues_ = false;
    LabelChoice* labels_;
    MaskPanel* mask_;
    ThresholdField* threshold_;
    SeedList* seeds_;
    QCheckBox* tubes_;
    QPushButton* path_;
    NumberField* minLength_;
    NumberField* minRadius_;
    QComboBox* components_;
    QCheckBox* keepLoops_;
    QPushButton* trace_;
    QPushButton* stop_;
    QLabel* note_;
    QLabel* lumenWarning_;
    QWidget* lumenCard_;
};

}   // namespace angiopose::ui
