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

/// The vessels of a case: the tree shown in all views, its origin, and the marks of its branches. The large inputs are
/// shared and never change after loading.
struct Vessels {
    InputFile file;   ///< centerlines, or the data they are traced from; a folder for a DICOM series
    VesselInput input;   ///< type of `file`, and how it is traced
    std::shared_ptr<const Volume> scan;   ///< volume from which the tree was traced, or in which it lies; or null
    InputFile scanFile;   ///< file of `scan`, if the tree does not come from it
    std::string scanSeriesId;   ///< series of `scanFile`, if that is a DICOM folder
    StudyIdentity scanIdentity;   ///< patient of the scan, if it is DICOM
    std::shared_ptr<const VoxelMask> lumen;   ///< voxels from which the tree was traced, or null
    std::shared_ptr<const VesselTree> tree;   ///< null until loaded
    bool isLumenEdited = false;   ///< edited manually: `file` is that mask, kept next to the case; no path: unsaved
    bool isTreeEdited = false;   ///< edited manually: differs from the file, so the case stores the tree itself
    std::vector<int> auxiliaryBranchIds;
    std::vector<int> excludedBranchIds;
    std::vector<int> hiddenBranchIds;   ///< used in the registration, but not drawn
    std::optional<Eigen::Vector3d> pickedPivotInPatient;   ///< see pivotInPatient
    std::vector<VesselMark> marks;   ///< target points and ostium rings, named by the user
    std::vector<SliceMeasurement> measurements;   ///< drawn in slices of the scan
};

/// Returns the center of manual rotations, to which displayed and locked shifts refer: the picked point or the tree's
/// centroid; nothing without a tree.
std::optional<Eigen::Vector3d> pivotInPatient(const Vessels& vessels);

}   // namespace angiopose::core
