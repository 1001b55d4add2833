#pragma once

#include "app/texts/dicom_export.h"
#include "io/dicom/objects/derived_object.h"
#include "io/dicom/objects/vessel_segmentation.h"

namespace angiopose::app {

/// Input common to all objects of one export.
struct DicomExportInput {
    const core::Case& session;
    const core::Centerline2d& target;
    const DicomExport& dicomExport;
    io::SourceImage angiogram;
    io::ScanReference scan;
    io::ObjectOrigin origin;
    DicomObserver shouldContinue;   ///< called with the completed fraction while an object is created
};

/// Returns the bytes of one object; the case must contain vessels and an image. Adds remarks to `notes` on content that
/// the object cannot represent.
core::Result<std::string> dicomObject(DicomKind kind, const DicomExportInput& exportInput, core::Messages& notes);

/// Returns the DICOM references of the scan that contains the vessels; empty if it is not DICOM or no longer available.
io::ScanReference scanReferenceOf(const core::Vessels& vessels);

}   // namespace angiopose::app
