#pragma once

#include "app/document/case_document.h"
#include "app/texts/deformed_vessels.h"

#include <QObject>

#include <cstddef>
#include <optional>

namespace angiopose::app {

/// Source of a pose that is shown instead of the document's.
enum class PreviewOf { Drag, Run, Start, Replay, Swing, Solution, Snapshot, Frame };

/// Whether residual colors are valid for a temporarily shown pose: a dragged pose is evaluated as it moves, other poses
/// are not, and residual colors of a different pose would mislead.
enum class ResidualColors { Kept, Hidden };

/// Currently shown pose, either the document's or a temporary preview, and the shape of the vessels. There is one
/// preview at a time: a new one replaces the previous one, whose owner is notified, and each owner can end only its
/// own.
class PosePreview : public QObject {
    Q_OBJECT
public:
    explicit PosePreview(const CaseDocument& document, QObject* parent = nullptr);

    void show(PreviewOf whose, const core::RigidTransform& cameraFromPatient, ResidualColors colors);
    void end(PreviewOf whose);   ///< shows the document's pose again, unless another preview has taken over

    std::optional<PreviewOf> shown() const { return shown_; }   ///< empty: the document's pose
    const core::RigidTransform& pose() const;   ///< camera from patient, as shown
    /// Camera from patient in any view of the case, as shown: if the views are linked, a preview moves them all;
    /// initial poses are per view, and tracking moves only the shown view.
    core::RigidTransform poseIn(std::size_t view) const;
    void setMovesAllViews(bool all);   ///< for cases with several views
    bool movesAllViews() const { return movesAllViews_; }
    ResidualColors colors() const { return colors_; }

    /// Selects the vessel shape on the images, if a deformation is known for the shown pose; `setMotionColored` colors
    /// the vessels by displacement.
    void setShape(VesselShape shape);
    VesselShape shape() const { return shape_; }
    void setMotionColored(bool colored);
    bool isMotionColored() const { return isMotionColored_; }

signals:
    void changed();
    void gaveWay(app::PreviewOf whose);   ///< preview replaced by another one

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
