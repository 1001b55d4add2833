#pragma once

#include "app/document/case_document.h"
#include "ui/words/pose_axis.h"
#include "ui/words/retranslation.h"

#include <QElapsedTimer>
#include <QObject>

#include <optional>

namespace angiopose::app {

/// Lets the user edit the pose with number fields, keys and drags. A burst of edits of the same kind is one undo step.
class PoseController : public QObject {
    Q_OBJECT
public:
    explicit PoseController(CaseDocument& document, QObject* parent = nullptr);

    /// Returns the pose relative to the initial pose; nullopt without a tree, a camera or an initial pose.
    std::optional<core::PoseOffset> currentOffset() const;
    bool differsFromInitialPose() const;
    const ui::PoseLocks& locks() const { return document_.current().options.locks; }
    void setMovesAllViews(bool all) { movesAllViews_ = all; }   ///< whether edits move all views of the case
    void setLocks(const ui::PoseLocks& locks);   ///< changes the locks in one undo step

    void setOffset(const core::PoseOffset& fromStart);
    void nudge(const ui::Nudge& nudge);
    void reset();

    void startDrag();
    void drag(const core::PoseOffset& sinceStart);
    void finishDrag();
    void cancelDrag();

signals:
    void previewed(const core::RigidTransform& cameraFromPatient);   ///< emitted during a drag
    void previewEnded();
    void refused(const QString& reason);

private:
    struct Frame {
        core::RigidTransform initialPose;
        core::ProjectionCamera camera;
        Eigen::Vector3d pivotInPatient;
    };
    std::optional<Frame> frame() const;
    void move(const core::RigidTransform& pose, const ui::LocalizedText& name, int mergeId);
    void push(std::vector<core::View> moved, const ui::LocalizedText& name, int mergeId);
    bool movesOtherViews() const { return movesAllViews_ && document_.current().views.size() > 1; }
    int mergeIdFor(int kind);

    CaseDocument& document_;
    std::optional<core::RigidTransform> dragStart_;
    std::optional<core::RigidTransform> dragged_;
    QElapsedTimer sinceEdit_;
    int mergeId_ = 0;
    int mergeKind_ = -1;
    bool movesAllViews_ = true;
};

}   // namespace angiopose::app
