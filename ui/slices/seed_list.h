#pragma once

#include <Eigen/Core>
#include <QWidget>

#include <vector>

class QListWidget;
class QPushButton;

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

}   // namespace angiopose::ui
