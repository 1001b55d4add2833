#pragma once

#include "app/document/case_document.h"
#include "app/texts/deformed_vessels.h"

#include <QObject>

#include <cstddef>
#include <optional>

namespace angiopose::app {

/// Source of a pose that is shown temporarily instead of the document's pose.
enum class PreviewSource { Drag, Run, Start, Replay, Swing, Solution, Snapshot, Frame };

/// Whether residual colors apply to a temporarily shown pose. A dragged pose is evaluated as it moves; with other
/// poses, the colors would belong to a different one.
enum class ResidualColors { Visible, Hidden };

/// Current pose on screen (that of the document or of a temporary preview) and shape of the vessels. Only one preview
/// exists at a time: a new one replaces the previous one and notifies its owner. An owner can end only its own preview.
class PosePreview : public QObject {
    Q_OBJECT
public:
    explicit PosePreview(const CaseDocument& document, QObject* parent = nullptr);

    void show(PreviewSource source, const core::RigidTransform& cameraFromPatient, ResidualColors colors);
    void end(PreviewSource source);   ///< returns to the document's pose unless another preview has taken over

    std::optional<PreviewSource> shown() const { return source_; }   ///< nullopt if the document's pose is shown
    const core::RigidTransform& pose() const;   ///< shown pose, camera from patient
    /// Returns the pose on screen of any view of the case, camera from patient. If the views are linked, a preview
    /// moves all of them; initial poses exist for each view, and tracking moves only the shown view.
    core::RigidTransform poseOfView(std::size_t view) const;
    void setMovesAllViews(bool all);   ///< sets whether a preview moves all views of the case
    bool movesAllViews() const { return movesAllViews_; }
    ResidualColors colors() const { return colors_; }

    /// Selects the vessel shape on the images, which has an effect only if a deformation is known for the pose on
    /// screen. `setMotionColored` colors the vessels by displacement.
    void setShape(VesselShape shape);
    VesselShape shape() const { return shape_; }
    void setMotionColored(bool colored);
    bool isMotionColored() const { return isMotionColored_; }

signals:
    void changed();
    void replaced(app::PreviewSource source);   ///< emitted when another preview has replaced this one

private:
    const CaseDocument& document_;
    std::optional<PreviewSource> source_;
    core::RigidTransform pose_;   ///< pose of the preview
    ResidualColors colors_ = ResidualColors::Visible;
    bool movesAllViews_ = true;
    VesselShape shape_ = VesselShape::Deformed;
    bool isMotionColored_ = false;
};

}   // namespace angiopose::app
