#pragma once

#include "app/document/case_document.h"
#include "app/jobs/evaluation_job.h"
#include "app/review/overlay_style_controller.h"
#include "app/showing/pose_preview.h"
#include "app/texts/deformed_vessels.h"
#include "app/views/view_controller.h"
#include "app/views/view_summary.h"

#include <QObject>

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

namespace angiopose::ui {
class AngiogramView;
class ViewPane;
}   // namespace angiopose::ui

namespace angiopose::app {

/// Keeps a pane in sync with one of the case's views other than the shown one: its frame, and the vessels at its own
/// pose or moved by a linked preview, with residual colors relative to its own image. Redraws only what has changed.
class SecondaryViewController : public QObject {
    Q_OBJECT
public:
    /// Objects that the pane shows or uses.
    struct Parts {
        const CaseDocument& document;
        const PosePreview& preview;
        const ViewController& views;
        OverlayStyleController& overlayStyle;
        ui::AngiogramView& shown;   ///< view whose display settings the pane adopts
        ui::ViewPane& pane;
    };
    explicit SecondaryViewController(const Parts& parts, QObject* parent = nullptr);

    void show(std::size_t viewIndex);   ///< shows the view at index `viewIndex` in the case
    void showPose();   ///< shows the pose of the document, or that of a linked preview
    void showColors();   ///< evaluates the pose unless that was already done
    void applyDisplaySettings();
    void clear();   ///< releases all data of the case
    std::size_t viewIndex() const { return viewIndex_; }

private:
    /// Everything on which the residual colors depend.
    struct ColorInputs {
        ViewKey key;   ///< view at the shown pose
        std::shared_ptr<const core::VesselTree> tree;
        std::vector<int> excluded;
        std::shared_ptr<const core::Centerline2d> target;

        bool operator==(const ColorInputs&) const = default;
    };
    const core::Case& current() const { return parts_.document.current(); }
    const core::View& view() const { return current().views[viewIndex_]; }
    void showTree();
    void showShape();
    void drawTree();
    void showImage();
    void showFrame();
    void showResiduals(const core::PoseEvaluation& evaluation);
    void hideResiduals();

    Parts parts_;
    std::size_t viewIndex_ = 0;
    std::shared_ptr<const core::VesselTree> tree_;
    std::vector<int> hidden_;
    DrawnVessels drawnVessels_;
    std::shared_ptr<const core::Angiogram> angiogram_;
    int frame_ = -1;
    core::RigidTransform pose_;
    bool isWindowLevelManual_ = false;   ///< true if the user, not a new image, set the window/level
    std::optional<ColorInputs> coloredFor_;
    EvaluationJob job_;
};

}   // namespace angiopose::app
