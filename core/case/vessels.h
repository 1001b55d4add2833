#pragma once

#include "core/case/input_file.h"
#include "core/imaging/angiogram.h"
#include "core/imaging/slice_measurement.h"
#include "core/imaging/volume.h"
#include "core/tracing/volume/vessel_input.h"
#include "core/vessel/vessel_mark.h"
#include "core/vessel/vessel_tree.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace angiopose::core {

/// The vessels of a case: the tree that all its views show, where it comes from, and the marks of its branches. The
/// large inputs are shared and never change once loaded.
struct Vessels {
    InputFile file;   ///< centrelines, or what they are traced from; a folder for a DICOM series
    VesselInput input;   ///< what `file` is, and how it is traced
    std::shared_ptr<const Volume> scan;   ///< the tree was traced from it or lies in it; or null
    InputFile scanFile;   ///< of `scan`, where the tree does not come from it
    std::string scanSeriesId;   ///< of `scanFile`, where that is a DICOM folder
    StudyIdentity scanIdentity;   ///< of the patient in the scan, where it is DICOM
    std::shared_ptr<const VoxelMask> lumen;   ///< the voxels the tree was traced from, or null
    std::shared_ptr<const VesselTree> tree;   ///< null until loaded
    bool isLumenEdited = false;   ///< by hand: `file` is that mask, kept beside the case; no path: not saved yet
    bool isTreeEdited = false;   ///< by hand: no longer what the file gives, so that the case keeps the tree itself
    std::vector<int> auxiliaryBranchIds;
    std::vector<int> excludedBranchIds;
    std::vector<int> hiddenBranchIds;   ///< count, but are not drawn
    std::optional<Eigen::Vector3d> pickedPivotInPatient;   ///< see pivotInPatient
    std::vector<VesselMark> marks;   ///< check points and rings, as the user named them
    std::vector<SliceMeasurement> measurements;   ///< drawn in slices of the scan
};

/// What the vessels turn about by hand, and whose shifts are shown and locked: picked, or the tree's centroid; nothing
/// without a tree.
std::optional<Eigen::Vector3d> pivotInPatient(const Vessels& vessels);

}   // namespace angiopose::core
