#pragma once

#include "app/document/case_document.h"
#include "app/texts/deformed_vessels.h"

#include <QObject>

#include <cstddef>
#include <optional>

namespace angiopose::app {

/// Whose pose is shown in place of the document's.
enum class PreviewOf { Drag, Run, Start, Replay, Swing, Solution, Snapshot, Frame };

/// Whether residual colours hold for a pose that is shown for a while: a drag is judged as it moves, a look at another
/// pose is not, and colours of one pose on another would lie.
enum class ResidualColors { Kept, Hidden };

/// Which pose is shown: the document's, or one that somebody shows for a while; and which vessels at it. There is one
/// at a time: the newest is seen, whom it takes the place of is told, and each can end its own only.
class PosePreview : public QObject {
    Q_OBJECT
public:
    explicit PosePreview(const CaseDocument& document, QObject* parent = nullptr);

    void show(PreviewOf whose, const core::RigidTransform& cameraFromPatient, ResidualColors colors);
    void end(PreviewOf whose);   ///< the document's is shown again, unless another's has taken the place

    std::optional<PreviewOf> shown() const { return shown_; }   ///< nothing: the document's pose
    const core::RigidTransform& pose() const;   ///< camera from patient, as it is shown
    /// Camera from patient in any view of the case as it is shown: where the views move together, the others go along
    /// with a preview; each has its own start pose, and following a run moves none but the shown one.
    core::RigidTransform poseIn(std::size_t view) const;
    void setMovesAllViews(bool all);   ///< where the case has several
    bool movesAllViews() const { return movesAllViews_; }
    ResidualColors colors() const { return colors_; }

    /// How the vessels lie on the images where bent ones are known of the pose that is shown, and whether their colours
    /// tell how far these moved.
    void setShape(VesselShape shape);
    VesselShape shape() const { return shape_; }
    void setMotionColored(bool colored);
    bool isMotionColored() const { return isMotionColored_; }

signals:
    void changed();
    void gaveWay(app::PreviewOf whose);   ///< to another's

private:
    const CaseDocument& document_;
    std::optional<PreviewOf> shown_;
    core::RigidTransform pose_;   ///< of the preview
    ResidualColors colors_ = ResidualColors::Kept;
    bool movesAllViews_ = true;
    VesselShape shape_ = VesselShape::Deformed;
    bool isMotionColored_ = false;
};

}   // namespace angiopose::app
