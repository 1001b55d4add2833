#pragma once

#include "core/imaging/volume.h"
#include "io/dicom/objects/derived_object.h"

#include <Eigen/Core>
#include <string>
#include <vector>

namespace angiopose::io {

/// References to the DICOM scan that contains the vessels; empty if the scan is not DICOM.
struct ScanReference {
    /// A single image of the series, or a frame of a multi-frame image.
    struct Slice {
        std::string sopInstanceUid;
        int frame = 0;
        bool isOneOfMany = false;   ///< whether the slice is a frame of a multi-frame instance
        Eigen::Vector3d position = Eigen::Vector3d::Zero();   ///< center of the first pixel, patient LPS mm
    };
    SourceImage source;   ///< header of any one of the images
    std::vector<Slice> slices;
};

/// Returns the vessels of a scan as a binary Segmentation (PS3.3 A.51) with one segment (arteries) and one frame per
/// plane of the mask, which has the voxel grid of the scan. Each frame references the slice at its position. Fails if
/// no voxel is set. `algorithm` describes how the mask was created.
core::Result<std::string> encodeVesselSegmentation(const core::VoxelMask& vessels, const std::string& algorithm,
                                                   const ScanReference& scan, const ObjectOrigin& origin);

/// Returns the frame of reference UID of a scan, or one derived from `fallback` if the scan has none.
std::string scanFrameOfReference(const SourceImage& scan, const std::string& fallback);

}   // namespace angiopose::io
