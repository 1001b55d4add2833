#pragma once

#include "core/imaging/volume.h"
#include "io/dicom/objects/derived_object.h"

#include <Eigen/Core>
#include <string>
#include <vector>

namespace angiopose::io {

/// DICOM references of the scan that contains the vessels; empty if the scan is not DICOM.
struct ScanReference {
    /// One image of the series, or one frame of it.
    struct Slice {
        std::string sopInstanceUid;
        int frame = 0;
        bool isOneOfMany = false;   ///< true: a frame of a multi-frame instance
        Eigen::Vector3d position = Eigen::Vector3d::Zero();   ///< center of the first pixel, patient LPS mm
    };
    SourceImage source;   ///< any one of the images
    std::vector<Slice> slices;
};

/// Vessels of a scan as a binary Segmentation (PS3.3 A.51): one segment, arteries, with one frame per plane of the
/// mask's grid, which is the scan's. Frames reference the slices at their positions. Fails if no voxel is set.
/// `algorithm`: description of how the mask was made.
core::Result<std::string> vesselSegmentation(const core::VoxelMask& vessels, const std::string& algorithm,
                                             const ScanReference& scan, const ObjectOrigin& origin);

/// The frame of reference of a scan's patient coordinates, or one derived from `fallback` if the scan has none.
std::string scanFrameOfReference(const SourceImage& scan, const std::string& fallback);

}   // namespace angiopose::io
