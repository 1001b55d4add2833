#pragma once

#include "core/registration_case.h"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
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

/// A case file's content before its inputs are loaded.
struct CaseDocument {
    core::RegistrationCase values;   ///< paths as written; cArm holds only what the file gives
    bool hasFrame = false;
    bool hasCurrentPose = false;
    std::optional<SubtractionKeys> subtraction;
    std::string sopInstanceUid;   ///< of the image, when noted
    std::vector<CaseDocument> views;   ///< of `values.otherViews`, in order, those without a file of their own
    core::Messages problems;   ///< what makes no sense, each with key and remedy
};

/// Content of a JSON text that follows the schema; unknown keys go to `values.extraKeys`.
CaseDocument parseCaseDocument(std::string_view json);

/// The case as JSON, paths relative to `folder`, unknown keys included.
std::string caseDocumentText(const core::RegistrationCase& registrationCase, const std::filesystem::path& folder);

}   // namespace angiopose::io