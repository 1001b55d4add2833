#pragma once

#include <Eigen/Core>
#include <QWidget>
#include <optional>
#include <utility>
#include <vector>

class QCheckBox;
class QListWidget;
class QPushButton;
class QSlider;

namespace angiopose::ui {

/// Effect of a click in a slice.
enum class TracingPick { Nothing, Seed, Avoid };

/// List of the seed points and avoid points for tracing, in patient coordinates (mm): clicks in a slice add points,
/// Delete removes the selected point. Passive view: displays the given state.
class SeedList : public QWidget {
    Q_OBJECT
public:
    using Points = std::vector<Eigen::Vector3d>;

    explicit SeedList(QWidget* parent = nullptr);

    void showPoints(const Points& seedsInPatient, const Points& avoidInPatient);   ///< emits no signal
    void showPick(TracingPick pick);   ///< emits no signal
    void setRunning(bool running);   ///< disables editing while tracing runs
    bool isPicking() const;

signals:
    void pickRequested(ui::TracingPick pick);
    void pointSelected(const Eigen::Vector3d& pointInPatient);
    void edited(const Points& seedsInPatient, const Points& avoidInPatient);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    QLayout* buttonRow();
    void fill();
    void choose(int row);
    void removeSelected();
    Points& listOf(int& row);   ///< returns the list that contains the row, and makes `row` an index into it

    Points seeds_;
    Points avoid_;
    bool running_ = false;
    QPushButton* pickSeed_;
    QPushButton* pickAvoid_;
    QPushButton* remove_;
    QListWidget* points_;
};

class NumberField;

/// Field for the intensity threshold of the vessels in a scan: automatic, or set with a slider or number field. Passive
/// view: displays the given state.
class ThresholdField : public QWidget {
    Q_OBJECT
public:
    explicit ThresholdField(QWidget* parent = nullptr);

    /// Sets the range of the threshold in HU, or in the intensity units of the scan.
    void showRange(std::pair<double, double> range, bool isHounsfield);
    void showManual(std::optional<double> threshold);   ///< manual threshold; if not set, the threshold is automatic
    void showAutomatic(std::optional<double> threshold);   ///< shows the automatic threshold, if known
    bool isPreviewWanted() const;
    std::optional<double> shown() const;   ///< threshold in use, manual or automatic

signals:
    void thresholdChosen(std::optional<double> threshold);
    void previewChanged();

private:
    QLayout* valueRow();
    void choose(std::optional<double> threshold);
    void showValues();

    std::optional<double> manualThreshold_;
    std::optional<double> automaticThreshold_;
    bool isHounsfield_ = true;
    QCheckBox* automatic_;
    NumberField* value_;
    QSlider* slider_;
    QCheckBox* preview_;
};

}   // namespace angiopose::ui
