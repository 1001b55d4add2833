#pragma once

#include "core/imaging/image2d.h"
#include "io/dicom/objects/derived_object.h"

#include <string>
#include <vector>

namespace angiopose::io {

/// Specifies whether images may contain burned-in patient data.
enum class BurnedInIdentity { None, Possible };

struct CapturedImages {
    std::vector<core::ColorImage> images;   ///< images, all of the same size
    double frameTimeMs = 0.0;   ///< frame interval of a cine run, ms; 0 if unknown
    BurnedInIdentity identity = BurnedInIdentity::Possible;
    std::string derivation;   ///< how the images were derived from the source
};

/// Returns a single image as a Secondary Capture Image (PS3.3 A.8.1), in RGB as displayed.
core::Result<std::string> encodeSecondaryCapture(const CapturedImages& capture, const SourceImage& source,
                                                 const ObjectOrigin& origin);

/// Returns the images of a cine run as a Multi-frame True Color Secondary Capture Image (PS3.3 A.8.5); releases each
/// image once it is copied. Fails if the result exceeds the size limit of an object.
core::Result<std::string> encodeMultiframeCapture(CapturedImages capture, const SourceImage& source,
                                                  const ObjectOrigin& origin);

}   // namespace angiopose::io
