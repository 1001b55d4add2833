#pragma once

#include "core/imaging/angiogram.h"
#include "core/support/message.h"
#include "core/support/result.h"

#include <Eigen/Core>
#include <array>
#include <optional>
#include <string>
#include <vector>

namespace angiopose::io {

/// Number of keys that can distinguish images of a series at the same position: acquisition, temporal position, cardiac
/// phase, trigger time, echo, stack.
inline constexpr std::size_t phaseKeyCount = 6;

/// Image of a DICOM series: a file, or a frame of a file.
struct SliceRecord {
    std::string path;
    int frame = 0;
    Eigen::Vector2i size = Eigen::Vector2i::Zero();   ///< number of columns and rows
    Eigen::Vector2d spacingMm = Eigen::Vector2d::Zero();   ///< pixel spacing along a row and along a column
    double statedStepMm = 0.0;   ///< Spacing Between Slices; 0 if absent
    std::optional<Eigen::Vector3d> position;   ///< center of the first pixel, patient LPS mm
    std::optional<Eigen::Matrix<double, 3, 2>> axes;   ///< unit directions along a row and along a column
    double slope = 1.0;
    double intercept = 0.0;
    int bitsStored = 16;
    bool isSigned = false;
    bool isFloat = false;
    std::string sopInstanceUid;
    int instanceNumber = 0;
    std::array<std::string, phaseKeyCount> phaseKeys;
};

/// Images of one DICOM file, with the series attributes of the file.
struct DicomImages {
    core::StudyIdentity identity;
    std::string seriesDescription;
    int seriesNumber = 0;
    std::string sopClassUid;
    bool isProjection = false;   ///< whether the images are X-ray projections rather than slices
    std::optional<core::Message> damage;
    std::vector<SliceRecord> slices;   ///< empty if the file contains no image
};

struct DicomFile;

/// Returns the images that a parsed file describes.
DicomImages imagesOf(const DicomFile& file, const std::string& path);

/// Reads the header of a DICOM file, single-frame or enhanced multi-frame (functional groups). Fails like `openInput`,
/// and if the file is not DICOM.
core::Result<DicomImages> readSliceRecords(const std::string& path);

}   // namespace angiopose::io
