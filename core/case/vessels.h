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

/// The vessels of a case: the tree shown in all views, the data it was traced from, and the user's marks. The large
/// inputs are shared and never change after loading.
struct Vessels {
    InputFile file;   ///< centerlines, or the data from which they are traced; a folder for a DICOM series
    VesselInput input;   ///< type of `file` and tracing options
    std::shared_ptr<const Volume> scan;   ///< volume from which the tree was traced, or in which it lies; or null
    InputFile scanFile;   ///< file of `scan`, if the tree was not traced from it
    std::string scanSeriesId;   ///< series in `scanFile`, if that is a DICOM folder
    StudyIdentity scanIdentity;   ///< patient data of the scan, if the scan is DICOM
    std::shared_ptr<const VoxelMask> lumen;   ///< voxels from which the tree was traced; may be null
    std::shared_ptr<const VesselTree> tree;   ///< null until loaded
    bool isLumenEdited = false;   ///< whether `file` is a manually edited mask next to the case (no path: unsaved)
    bool isTreeEdited = false;   ///< whether the tree was edited manually; the case then stores the tree itself
    std::vector<int> auxiliaryBranchIds;
    std::vector<int> excludedBranchIds;
    std::vector<int> hiddenBranchIds;   ///< branches that are registered but not displayed
    std::optional<Eigen::Vector3d> pickedPivotInPatient;   ///< point picked by the user; see pivotInPatient
    std::vector<VesselMark> marks;   ///< target points and ostium rings, named by the user
    std::vector<SliceMeasurement> measurements;   ///< measurements drawn in slices of the scan
};

/// Returns the center of rotation for manual adjustment, to which displayed and locked shifts also refer: the picked
/// point or the tree's centroid. Returns nullopt without a tree.
std::optional<Eigen::Vector3d> pivotInPatient(const Vessels& vessels);

}   // namespace angiopose::core
