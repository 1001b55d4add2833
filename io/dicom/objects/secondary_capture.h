#pragma once

#include "core/imaging/image2d.h"
#include "io/dicom/objects/derived_object.h"

#include <string>
#include <vector>

namespace angiopose::io {

/// What pictures show of a patient in letters.
enum class BurnedInIdentity { None, MayBeThere };

struct CapturedPictures {
    std::vector<core::ColorImage> pictures;   ///< of one size
    double frameTimeMs = 0.0;   ///< of a run; 0: not known
    BurnedInIdentity identity = BurnedInIdentity::MayBeThere;
    std::string derivation;   ///< what was done to the source, in words
};

/// One picture as a Secondary Capture Image (PS3.3 A.8.1), RGB as it is seen.
core::Result<std::string> secondaryCapture(const CapturedPictures& captured, const SourceImage& source,
                                           const ObjectOrigin& origin);

/// Pictures of a run, which are let go one by one, as a Multi-frame True Color Secondary Capture Image (PS3.3 A.8.5).
/// Fails where they are more than an object may hold.
core::Result<std::string> secondaryCaptureRun(CapturedPictures captured, const SourceImage& source,
                                              const ObjectOrigin& origin);

}   // namespace angiopose::io
