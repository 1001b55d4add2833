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

/// What a click in a slice does.
enum class TracingPick { Nothing, Seed, Avoid };

/// Seeds of the tracing and places that it is to avoid, in patient coordinates (mm), and what is done with them: the
/// next clicks in a slice add some, Delete takes one away. Shows what it is told.
class SeedList : public QWidget {
    Q_OBJECT
public:
    using Points = std::vector<Eigen::Vector3d>;

    explicit SeedList(QWidget* parent = nullptr);

    void showPoints(const Points& seedsInPatient, const Points& avoidInPatient);   ///< silent
    void showPick(TracingPick pick);   ///< silent
    void setRunning(bool running);   ///< nothing is changed meanwhile
    bool isPicking() const;

signals:
    void pickWanted(ui::TracingPick pick);
    void placeChosen(const Eigen::Vector3d& pointInPatient);
    void edited(const Points& seedsInPatient, const Points& avoidInPatient);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    QLayout* buttonRow();
    void fill();
    void choose(int row);
    void removeChosen();
    Points& holderOf(int& row);   ///< `row` becomes the place within it

    Points seeds_;
    Points avoid_;
    bool running_ = false;
    QPushButton* pickSeed_;
    QPushButton* pickAvoid_;
    QPushButton* remove_;
    QListWidget* points_;
};

class NumberField;

/// The value of a scan at which its vessels begin: found, or chosen by slider and number. Shows what it is told.
class ThresholdField : public QWidget {
    Q_OBJECT
public:
    explicit ThresholdField(QWidget* parent = nullptr);

    /// Values that it can have, in Hounsfield units or in the scan's own.
    void showRange(std::pair<double, double> range, bool isHounsfield);
    void showChosen(std::optional<double> threshold);   ///< nothing: automatic
    void showFound(std::optional<double> threshold);   ///< what "automatic" comes to, when known
    bool isPreviewWanted() const;
    std::optional<double> shown() const;   ///< chosen, or found

signals:
    void chosen(std::optional<double> threshold);
    void previewChanged();

private:
    QLayout* valueRow();
    void choose(std::optional<double> threshold);
    void showValues();

    std::optional<double> chosen_;
    std::optional<double> found_;
    bool isHounsfield_ = true;
    QCheckBox* automatic_;
    NumberField* value_;
    QSlider* slider_;
    QCheckBox* preview_;
};

}   // namespace angiopose::ui
