#pragma once

#include "core/support/result.h"
#include "io/dicom/dicom_file.h"

#include <string>

namespace angiopose::io {

/// What of DICOM can be freed of identity.
enum class FreedClass { Image, Segmentation, Report, PresentationState, Registration };

/// By its SOP class; an image where that tells nothing else. Fails, naming the file, where words or pages of the object
/// cannot be cleared for sure, and where it holds pixels that objects of its class do not have: they would be lost.
core::Result<FreedClass> freedClassOf(const DicomFile& file, const std::string& path);

}   // namespace angiopose::io
