#pragma once

#include "core/geometry/projection_camera.h"
#include "core/geometry/rigid_transform.h"
#include "core/vessel/centerline2d.h"
#include "core/vessel/vessel_tree.h"
#include "ui/scenes/cutout.h"
#include "ui/scenes/drr_tint.h"
#include "ui/scenes/gray_frame.h"
#include "ui/scenes/projected_tree.h"
#include "ui/scenes/resample_frame.h"
#include "ui/scenes/revision.h"
#include "ui/scenes/view_rect.h"

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <vector>

namespace angiopose::ui {

/// Display state of the branches, shared by all views.
struct BranchMarks {
    std::optional<int> hovered;
    std::set<int> selected;
    std::set<int> auxiliary;
    std::set<int> excluded;
    std::set<int> hidden;   ///< omitted from the trees of the scenes, but still listed and shown in slices

    bool operator==(const BranchMarks&) const = default;
};

enum class OverlayMode { Centerline, Outline, Tube, Hidden };

/// `NearBright` brightens vessels close to the X-ray source.
enum class DepthCue { None, NearBright };

/// Depth of the nearest and of the farthest point of a projected tree.
struct DepthRange {
    double nearMm = 0.0;
    double farMm = 0.0;
};

/// Complete input of a renderer: angiogram, overlay, and the appearance of both.
struct OverlayContent {
    GrayFrame frame;
    Interpolation interpolation = Interpolation::Smooth;
    DrrTint drr;
    Cutout cutout;
    ViewRect viewRect{-0.5, 511.5, -0.5, 511.5};   ///< part of the image shown in the view

    core::VesselTree tree;
    core::ProjectionCamera camera;
    core::RigidTransform cameraFromPatient;
    ProjectedTree projected;   ///< `tree` projected with `camera` and `cameraFromPatient`
    DepthRange depthRange;   ///< depth range of `projected`

    BranchMarks marks;
    OverlayMode mode = OverlayMode::Centerline;
    bool isOverlayHidden = false;   ///< whether the tree and the traced curves are hidden
    DepthCue depthCue = DepthCue::None;
    double opacity = 1.0;
    double lineWidthPx = 2.0;   ///< line width, device px
    core::Centerline2d traced;
    bool isTracedShown = false;
    std::map<int, std::vector<double>> residualPx;
    double scaleMaximumPx = 0.0;   ///< maximum of the residual scale; if 0, branches have their own colors

    std::uint64_t revision = nextRevision();   ///< changes with all but frame, cutout, interpolation and view rectangle
    std::uint64_t linesRevision = nextRevision();   ///< changes with points, marks and colors, but not with the pose
};

}   // namespace angiopose::ui
