#pragma once

#include "core/imaging/angiogram.h"
#include "core/support/message.h"
#include "core/tracing/angiogram/run/subtract_run.h"

#include <Eigen/Core>

#include <optional>
#include <string>
#include <vector>

namespace angiopose::io {

/// What a case says about subtraction; the rest is as the image's header has it.
struct SubtractionKeys {
    std::optional<std::vector<int>> maskFrames;   ///< empty: chosen automatically
    std::optional<core::MaskInterval> interval;
    std::optional<Eigen::Vector2d> maskShiftPx;
    bool isShiftAutomatic = false;
    std::optional<core::PixelRelation> relation;
};

/// What a case says about a view beside its values, for when the image is read.
struct ViewNotes {
    bool hasFrame = false;
    bool hasCurrentPose = false;
    std::vector<int> deviceCurveIds;   ///< of the edited curves, see core::CurvesApart
    std::optional<SubtractionKeys> subtraction;
    std::string sopInstanceUid;   ///< of the image, when noted
    core::Messages changedBesideResult;   ///< in the file, since the view's result was saved; see result_seal.h
    core::Messages changedBesideFollowed;   ///< likewise beside what following found
};

}   // namespace angiopose::io
