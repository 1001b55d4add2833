#pragma once

#include "core/geometry/landmark.h"
#include "ui/controls/section.h"

#include <QPushButton>

#include <vector>

class QAction;
class QListWidget;

namespace angiopose::ui {

/// What the landmark panel shows.
struct LandmarkState {
    std::vector<core::Landmark> landmarks;
    std::vector<double> errorPx;   ///< at the pose as it is, one each; empty without a pose
    QString verdict;   ///< what the pairs fix, or what they lack
    bool isEnough = false;   ///< a pose can be found
};

/// The pairs a start pose is found from: listed with what remains of each, removable, and the command to place the
/// vessels by them.
class LandmarkPanel : public Section {
    Q_OBJECT
public:
    explicit LandmarkPanel(QWidget* parent = nullptr);

    void showLandmarks(const LandmarkState& state);
    void bindMode(QAction& action);   ///< the switch that starts and ends clicking

signals:
    void removeRequested(const std::vector<int>& indices);
    void poseRequested();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void removeSelected();
    void showKeys();

    QListWidget* list_;
    QLabel* verdict_;
    QPushButton* mode_;
    QPushButton* place_;
    QPushButton* remove_;
    std::size_t count_ = 0;
};

}   // namespace angiopose::ui