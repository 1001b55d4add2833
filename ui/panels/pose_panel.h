#pragma once

#include "ui/controls/number_field.h"
#include "ui/controls/section.h"
#include "ui/words/pose_axis.h"

#include <QAbstractButton>

namespace angiopose::ui {

/// The pose relative to the start pose, in mm and degrees, with a lock per degree of freedom.
/// Shows what it is told, reports what the user wants; decides nothing.
class PosePanel : public Section {
    Q_OBJECT
public:
    explicit PosePanel(QWidget* parent = nullptr);

    void showOffset(const std::optional<core::PoseOffset>& offset);   ///< nothing: there is no pose to edit yet
    void showLocks(const PoseLocks& locks);
    void showPickedPivot(bool isPicked);   ///< else the numbers are about the centroid
    void showNudgeMode(bool on);
    void setActiveAxis(std::optional<PoseAxis> axis);   ///< the one in use, marked
    void showDepthDoubt(std::optional<double> depthSigmaMm);   ///< what one view hardly tells, marked in amber

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