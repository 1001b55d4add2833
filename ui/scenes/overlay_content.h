#pragma once

#include "core/geometry/projection_camera.h"
#include "core/geometry/rigid_transform.h"
#include "core/vessel/centerline2d.h"
#include "core/vessel/vessel_tree.h"
#include "ui/scenes/cutout.h"
#include "ui/scenes/gray_frame.h"
#include "ui/scenes/projected_tree.h"
#include "ui/scenes/radiograph_tint.h"
#include "ui/scenes/resample_frame.h"
#include "ui/scenes/revision.h"
#include "ui/scenes/view_rect.h"

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <vector>

namespace angiopose::ui {

/// How branches are shown, the same in every view.
struct BranchMarks {
    std::optional<int> hovered;
    std::set<int> selected;
    std::set<int> auxiliary;
    std::set<int> excluded;
    std::set<int> hidden;   ///< not in the scenes' trees; lists and slices show that

    bool operator==(const BranchMarks&) const = default;
};

enum class OverlayMode { Centerline, Outline, Tube, Hidden };

/// NearBright shows which vessels lie nearer to the source.
enum class DepthCue { None, NearBright };

/// Nearest and farthest point of a projected tree.
struct DepthRange {
    double nearMm = 0.0;
    double farMm = 0.0;
};

/// What lies on the angiogram and how it looks: all that a renderer is told.
struct OverlayContent {
    GrayFrame frame;
    Interpolation interpolation = Interpolation::Smooth;
    RadiographTint radiograph;
    Cutout cutout;
    ViewRect viewRect{-0.5, 511.5, -0.5, 511.5};   ///< what of the image fills the picture

    core::VesselTree tree;
    core::ProjectionCamera camera;
    core::RigidTransform cameraFromPatient;
    ProjectedTree projected;   ///< the tree as camera and pose put it on the image
    DepthRange depthRange;   ///< of `projected`

    BranchMarks marks;
    OverlayMode mode = OverlayMode::Centerline;
    bool isVeiled = false;   ///< neither tree nor traced curves
    DepthCue depthCue = DepthCue::None;
    double opacity = 1.0;
    double lineWidthPx = 2.0;   ///< device px
    core::Centerline2d traced;
    bool isTracedShown = false;
    std::map<int, std::vector<double>> residualPx;
    double scaleMaximumPx = 0.0;   ///< 0: branches in their own colours

    std::uint64_t revision = nextRevision();   ///< changes with all but frame, cutout, interpolation and view rectangle
    std::uint64_t linesRevision = nextRevision();   ///< changes with points, marks and tones, not with the pose
};

}   // namespace angiopose::ui
