#pragma once

#include "core/geometry/landmark.h"
#include "ui/controls/section.h"

#include <QPushButton>

#include <vector>

class QAction;
class QListWidget;

namespace angiopose::ui {

/// Values shown by the landmark panel.
struct LandmarkState {
    std::vector<core::Landmark> landmarks;
    std::vector<double> errorPx;   ///< reprojection error of each pair at the current pose, px; empty without a pose
    QString verdict;   ///< pose parameters that the pairs determine, or what is still missing
    bool isEnough = false;   ///< true if the pairs suffice to determine a pose
};

/// Panel for the landmark pairs that determine the initial pose: lists each pair with its residual, removes pairs, and
/// determines the pose from them.
class LandmarkPanel : public Section {
    Q_OBJECT
public:
    explicit LandmarkPanel(QWidget* parent = nullptr);

    void showLandmarks(const LandmarkState& state);
    void bindMode(QAction& action);   ///< connects the action that toggles landmark picking

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
    QPushButton* modeButton_;
    QPushButton* place_;
    QPushButton* remove_;
    std::size_t count_ = 0;
};

}   // namespace angiopose::ui
