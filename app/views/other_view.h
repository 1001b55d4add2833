#pragma once

#include "app/document/case_document.h"
#include "app/jobs/judge_job.h"
#include "app/review/look_controller.h"
#include "app/showing/pose_preview.h"
#include "app/texts/deformed_vessels.h"
#include "app/views/look_at_view.h"
#include "app/views/view_controller.h"

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

/// Keeps a pane showing one view of the case beside the shown one: its frame, the vessels at its pose or as they go
/// along with a preview, coloured by how they agree with this view's own image. Redraws only what changed.
class OtherView : public QObject {
    Q_OBJECT
public:
    /// What it shows, and where.
    struct Parts {
        const CaseDocument& document;
        const PosePreview& preview;
        const ViewController& views;
        LookController& look;
        ui::AngiogramView& shown;   ///< whose look it takes
        ui::ViewPane& pane;
    };
    explicit OtherView(const Parts& parts, QObject* parent = nullptr);

    void show(std::size_t place);   ///< of the case's views, as they are now
    void showPose();   ///< of the document, or with a preview
    void showColors();   ///< judges the pose where that was not done yet
    void takeLook();
    void clear();   ///< holds nothing of the case any more
    std::size_t place() const { return place_; }

private:
    /// All that the residual colours hang on.
    struct Judged {
        ViewSight sight;   ///< at the pose as it was shown
        std::shared_ptr<const core::VesselTree> tree;
        std::vector<int> excluded;
        std::shared_ptr<const core::Centerline2d> target;

        bool operator==(const Judged&) const = default;
    };
    const core::Case& current() const { return on_.document.current(); }
    const core::View& view() const { return current().views[place_]; }
    void showTree();
    void showShape();
    void drawTree();
    void showImage();
    void showFrame();
    void showResiduals(const core::PoseJudgement& judgement);
    void hideResiduals();

    Parts on_;
    std::size_t place_ = 0;
    std::shared_ptr<const core::VesselTree> tree_;
    std::vector<int> hidden_;
    DrawnVessels drawn_;
    std::shared_ptr<const core::Angiogram> angiogram_;
    int frame_ = -1;
    core::RigidTransform pose_;
    bool isBrightnessOwn_ = false;   ///< set by the user, not by an image that is new here
    std::optional<Judged> judged_;
    JudgeJob job_;
};

}   // namespace angiopose::app
