#pragma once

#include "core/imaging/image2d.h"
#include "io/dicom/objects/derived_object.h"

#include <string>
#include <vector>

namespace angiopose::io {

/// Whether images may contain burned-in patient data.
enum class BurnedInIdentity { None, MayBeThere };

struct CapturedPictures {
    std::vector<core::ColorImage> pictures;   ///< of equal size
    double frameTimeMs = 0.0;   ///< of a cine run; 0: unknown
    BurnedInIdentity identity = BurnedInIdentity::MayBeThere;
    std::string derivation;   ///< description of the processing of the source
};

/// One image as a Secondary Capture Image (PS3.3 A.8.1), RGB as displayed.
core::Result<std::string> secondaryCapture(const CapturedPictures& captured, const SourceImage& source,
                                           const ObjectOrigin& origin);

/// The images of a cine run as a Multi-frame True Color Secondary Capture Image (PS3.3 A.8.5); releases them one by
/// one. Fails if they exceed the size limit of an object.
core::Result<std::string> secondaryCaptureRun(CapturedPictures captured, const SourceImage& source,
                                              const ObjectOrigin& origin);

}   // namespace angiopose::io
