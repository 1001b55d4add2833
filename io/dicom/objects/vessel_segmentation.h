#pragma once

#include "core/imaging/volume.h"
#include "io/dicom/objects/derived_object.h"

#include <Eigen/Core>
#include <string>
#include <vector>

namespace angiopose::io {

/// The scan that vessels lie in, as DICOM knows it; of another kind of file all is empty.
struct ScanReference {
    /// One image of the series, or one frame of it.
    struct Slice {
        std::string sopInstanceUid;
        int frame = 0;
        bool isOneOfMany = false;   ///< frames of an instance
        Eigen::Vector3d position = Eigen::Vector3d::Zero();   ///< centre of the first pixel, patient LPS mm
    };
    SourceImage source;   ///< one of the images
    std::vector<Slice> slices;
};

/// Vessels of a scan as a binary Segmentation (PS3.3 A.51): one segment, arteries, one frame for every plane of the
/// mask's grid, which is the scan's. Frames refer to the slices that they lie on. Fails where no voxel is marked.
/// `algorithm`: how the mask was made, in words.
core::Result<std::string> vesselSegmentation(const core::VoxelMask& vessels, const std::string& algorithm,
                                             const ScanReference& scan, const ObjectOrigin& origin);

/// The frame of reference of patient coordinates in a scan: its own, or one that follows from `fallback`.
std::string scanFrameOfReference(const SourceImage& scan, const std::string& fallback);

}   // namespace angiopose::io
