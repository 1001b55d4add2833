#pragma once

#include "ui/controls/number_field.h"
#include "ui/controls/section.h"
#include "ui/words/pose_axis.h"

#include <QAbstractButton>

namespace angiopose::ui {

/// Panel for the pose relative to the initial pose, in mm and degrees, with a lock per degree of freedom. Passive view:
/// displays the given state and emits signals for user actions.
class PosePanel : public Section {
    Q_OBJECT
public:
    explicit PosePanel(QWidget* parent = nullptr);

    void showOffset(const std::optional<core::PoseOffset>& offset);   ///< without a value, there is no pose to edit yet
    void showLocks(const PoseLocks& locks);
    void showPickedPivot(bool isPicked);   ///< if false, the rotation center is the centroid
    void showNudgeMode(bool on);
    void setActiveAxis(std::optional<PoseAxis> axis);   ///< highlights the axis in use
    void showDepthUncertainty(
        std::optional<double> depthSigmaMm);   ///< depth uncertainty of a single view, which is shown in amber

signals:
    void offsetEdited(const core::PoseOffset& offset);
    void locksEdited(const ui::PoseLocks& locks);
    void resetRequested();

private:
    struct Row {
        QLabel* label;
        NumberField* field;
        QAbstractButton* lock;
    };
    Row makeRow(PoseAxis axis);
    void editAxis(PoseAxis axis, double value);
    void toggleLock(PoseAxis axis);
    QString wordsOf(PoseAxis axis) const;
    void mark();

    core::PoseOffset offset_;
    bool isNudging_ = false;
    PoseLocks locks_{};
    std::optional<PoseAxis> activeAxis_;
    std::optional<double> depthSigmaMm_;
    std::array<Row, poseAxes.size()> rows_{};
    QLabel* pivotNote_ = nullptr;
    QAbstractButton* reset_;
};

}   // namespace angiopose::ui
