#pragma once

#include "core/imaging/angiogram.h"
#include "core/support/message.h"
#include "core/tracing/angiogram/run/subtract_run.h"

#include <Eigen/Core>

#include <optional>
#include <string>
#include <vector>

namespace angiopose::io {

/// The subtraction settings given in a case; the others follow the image's header.
struct SubtractionKeys {
    std::optional<std::vector<int>> maskFrames;   ///< empty: chosen automatically
    std::optional<core::MaskInterval> interval;
    std::optional<Eigen::Vector2d> maskShiftPx;
    bool isShiftAutomatic = false;
    std::optional<core::PixelRelation> relation;
};

/// Information about a view in a case file that is needed once its image is read.
struct ViewNotes {
    bool hasFrame = false;
    bool hasCurrentPose = false;
    std::vector<int> deviceCurveIds;   ///< device curves among the edited curves, see core::CurvesApart
    std::optional<SubtractionKeys> subtraction;
    std::string sopInstanceUid;   ///< of the image, if stored
    core::Messages
        changedBesideResult;   ///< parts of the file that changed since the view's result was saved; see result_seal.h
    core::Messages changedBesideFollowed;   ///< the same for the tracking result
};

}   // namespace angiopose::io
