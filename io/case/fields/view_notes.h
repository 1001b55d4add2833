#pragma once

#include "core/imaging/angiogram.h"
#include "core/support/message.h"
#include "core/tracing/angiogram/run/subtract_run.h"

#include <Eigen/Core>

#include <optional>
#include <string>
#include <vector>

namespace angiopose::io {

/// Subtraction settings specified in a case. The image header determines those without a value.
struct SubtractionOverrides {
    std::optional<std::vector<int>> maskFrames;   ///< if not set, mask frames are selected automatically
    std::optional<core::MaskInterval> interval;
    std::optional<Eigen::Vector2d> maskShiftPx;
    bool isShiftAutomatic = false;
    std::optional<core::PixelRelation> relation;
};

/// Information from a case file that is needed once the image of the view has been read.
struct ViewNotes {
    bool hasFrame = false;
    bool hasCurrentPose = false;
    std::vector<int> deviceCurveIds;   ///< IDs of the edited curves that are devices, see core::separateDevices
    std::optional<SubtractionOverrides> subtraction;
    std::string sopInstanceUid;   ///< SOP instance UID of the image, if stored
    core::Messages changedSinceResult;   ///< parts of the file that changed after the view's result was saved
    core::Messages changedSinceTracking;   ///< the same for the tracking result
};

}   // namespace angiopose::io
