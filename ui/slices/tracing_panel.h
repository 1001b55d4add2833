#pragma once

#include "core/tracing/volume/vessel_input.h"
#include "ui/controls/section.h"

#include <optional>

class QAction;
class QCheckBox;
class QComboBox;
class QListWidget;
class QPushButton;
class QSlider;

namespace angiopose::ui {

class LabelChoice;
class MaskPanel;
class NumberField;

/// What a click in a slice does.
enum class TracingPick { Nothing, Seed, Avoid };

/// How the vessels of a scan are traced: threshold, seeds, places to avoid, limits. Shows what it is told, reports what
/// the user wants.
class TracingPanel : public Section {
    Q_OBJECT
public:
    explicit TracingPanel(QWidget* parent = nullptr);

    void showOptions(const core::VesselTracingOptions& options);   ///< silent
    /// Values that a threshold can have; nothing: what is traced has no values (labels, surface).
    void showRange(std::optional<std::pair<double, double>> range, const QString& unit);
    LabelChoice& labels() { return *labels_; }
    MaskPanel& mask() { return *mask_; }
    void bindPath(QAction& action);   ///< one vessel by two clicks
    void showFound(std::optional<double> threshold);   ///< what "automatic" comes to, when known
    void showPick(TracingPick pick);
    void showWhyNot(const QString& reason);   ///< empty: can be traced
    void setRunning(bool running);
    bool isPreviewWanted() const;
    std::optional<double> thresholdShown() const;   ///< chosen, or found

signals:
    void optionsEdited(const core::VesselTracingOptions& options);
    void pickWanted(ui::TracingPick pick);
    void previewChanged();
    void placeChosen(const Eigen::Vector3d& pointInPatient);
    void traceRequested();
    void stopRequested();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    QLayout* thresholdRows();
    QLayout* pointRows();
    QLayout* limitRows();
    QLayout* shapeRows();
    QLayout* buttonRow();
    void setThreshold(std::optional<double> threshold);
    void showThreshold();
    void fillPoints();
    void removePoint();
    void updateButtons();

    core::VesselTracingOptions options_;
    std::optional<double> found_;
    QString whyNot_;
    bool running_ = false;
    bool hasValues_ = false;
    LabelChoice* labels_;
    MaskPanel* mask_;
    QWidget* thresholdBox_;
    QCheckBox* automatic_;
    NumberField* threshold_;
    QSlider* slider_;
    QCheckBox* preview_;
    QPushButton* seed_;
    QPushButton* avoid_;
    QCheckBox* tubes_;
    QPushButton* path_;
    QListWidget* points_;
    QPushButton* remove_;
    NumberField* minLength_;
    NumberField* minRadius_;
    QComboBox* pieces_;
    QCheckBox* keepLoops_;
    QPushButton* trace_;
    QPushButton* stop_;
    QLabel* note_;
};

}   // namespace angiopose::ui