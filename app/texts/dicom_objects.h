#pragma once

#include "app/texts/dicom_export.h"
#include "io/dicom/objects/derived_object.h"
#include "io/dicom/objects/vessel_segmentation.h"

namespace angiopose::app {

/// What all objects of one export rest on.
struct DicomGround {
    const core::Case& session;
    const core::Centerline2d& target;
    const DicomExport& wanted;
    io::SourceImage angiogram;
    io::ScanReference scan;
    io::ObjectOrigin origin;
    DicomObserver shouldContinue;   ///< asked while an object is made: the part of it
};

/// The bytes of an object; `ground` must have vessels and an image. What it cannot hold is added to `notes`.
core::Result<std::string> dicomObject(DicomKind kind, const DicomGround& ground, core::Messages& notes);

/// Where the scan of the vessels comes from; empty where it is no DICOM, or not there any more.
io::ScanReference scanReferenceOf(const core::Vessels& vessels);

}   // namespace angiopose::app
