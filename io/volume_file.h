#pragma once

#include "core/imaging/angiogram.h"
#include "core/imaging/volume.h"
#include "core/support/result.h"
#include "io/support/read_observer.h"

#include <string>
#include <vector>

namespace angiopose::io {

/// A volume with what its file says besides.
struct LoadedVolume {
    core::Volume volume;
    std::string format;   ///< "NIfTI-1", "NRRD", "MetaImage", …, "DICOM series"
    core::StudyIdentity identity;   ///< of a DICOM series
    std::string seriesId;   ///< of a DICOM series, see `DicomSeries::id`
    bool isDeclaredLabels = false;   ///< the header calls the values labels
    core::Messages warnings;
};

/// What a volume file says before its voxels are read.
struct VolumeSummary {
    std::string format;
    std::string voxelType;   ///< as stored: "int16", …
    core::VolumeGeometry geometry;
    double slope = 1.0;
    double intercept = 0.0;
    bool isDeclaredLabels = false;
    core::Messages warnings;
};

/// True for content that `readVolume` understands without DICOM: NIfTI, Analyze, NRRD, MetaImage, legacy VTK images,
/// GIPL (by the first bytes).
bool isVolumeFile(const std::string& path);

/// Header of such a file.
core::Result<VolumeSummary> describeVolume(const std::string& path);

/// A volume from such a file, a DICOM slice (with the other slices of its series beside it), an enhanced
/// multi-frame DICOM file, or a folder of DICOM files. `seriesId` chooses among several series of a folder; empty:
/// there must be one volume only. Patient LPS; 16-bit voxels, read straight into place.
core::Result<LoadedVolume> readVolume(const std::string& path, const std::string& seriesId = {},
                                      const ReadObserver& observe = {});

/// A label image: such a file, or a DICOM segmentation (labels are segment numbers).
core::Result<core::LabelVolume> readLabels(const std::string& path, const ReadObserver& observe = {});

/// True for volumes whose values are labels: whole numbers from 0, mostly background, the rest in pieces of one value.
bool looksLikeLabels(const core::Volume& volume);
bool looksLikeLabels(const core::LabelVolume& image);

/// The labels of a volume for which `looksLikeLabels` holds.
core::LabelVolume labelsOf(const core::Volume& volume);

/// Writes .nii, .nii.gz, .nrrd or .mha by extension, atomically. NIfTI keeps slope and intercept; the others get the
/// values themselves, as 16 bit where these are whole numbers that fit, else as float.
core::Status writeVolume(const core::Volume& volume, const std::string& path);
core::Status writeLabels(const core::LabelVolume& labels, const std::string& path);

}   // namespace angiopose::io