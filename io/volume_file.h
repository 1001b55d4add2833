#pragma once

#include "core/imaging/angiogram.h"
#include "core/imaging/volume.h"
#include "core/support/result.h"
#include "io/support/read_observer.h"

#include <string>
#include <vector>

namespace angiopose::io {

/// A volume with the additional data of its file.
struct LoadedVolume {
    core::Volume volume;
    std::string format;   ///< format name: "NIfTI-1", "NRRD", "MetaImage" or "DICOM series"
    core::StudyIdentity identity;   ///< identity of a DICOM series
    std::string seriesId;   ///< ID of a DICOM series, see `DicomSeries::id`
    bool isDeclaredLabelMap = false;   ///< whether the header declares the values to be labels
    core::Messages warnings;
};

/// Properties of a volume file that are known before its voxels are read.
struct VolumeSummary {
    std::string format;
    std::string voxelType;   ///< voxel type as stored, for example "int16"
    core::VolumeGeometry geometry;
    double slope = 1.0;
    double intercept = 0.0;
    bool isDeclaredLabelMap = false;
    core::Messages warnings;
};

/// Returns whether the file, judged by its first bytes, is a volume other than DICOM that `readVolume` can read: NIfTI,
/// Analyze, NRRD, MetaImage, legacy VTK image or GIPL.
bool isVolumeFile(const std::string& path);

/// Reads the header of a file that isVolumeFile accepts.
core::Result<VolumeSummary> describeVolume(const std::string& path);

/// Reads a volume from a file that isVolumeFile accepts, a DICOM slice (with the other slices of its series in the same
/// folder), an enhanced multi-frame DICOM file, or a folder of DICOM files. `seriesId` selects one of several series of
/// a folder; if empty, there must be only one volume. The 16-bit voxels in patient LPS are read directly into place.
core::Result<LoadedVolume> readVolume(const std::string& path, const std::string& seriesId = {},
                                      const ReadObserver& observe = {});

/// Reads a label image from a file that isVolumeFile accepts, or a DICOM segmentation (labels are segment numbers).
core::Result<core::LabelVolume> readLabels(const std::string& path, const ReadObserver& observe = {});

/// Returns whether the values look like labels: whole numbers from 0, mostly background, the rest in homogeneous areas.
bool looksLikeLabels(const core::Volume& volume);
bool looksLikeLabels(const core::LabelVolume& image);

/// Converts a volume that `looksLikeLabels` accepts to a label image.
core::LabelVolume labelsOf(const core::Volume& volume);

/// Atomically writes .nii, .nii.gz, .nrrd or .mha, depending on the extension. NIfTI keeps slope and intercept; the
/// other formats store the rescaled values, as 16-bit integers if they are whole numbers in range, otherwise as float.
core::Status writeVolume(const core::Volume& volume, const std::string& path);
core::Status writeLabels(const core::LabelVolume& labels, const std::string& path);

}   // namespace angiopose::io
