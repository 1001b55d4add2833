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

/// Number of keys that may distinguish images of one series at the same position: acquisition, temporal position,
/// cardiac phase, trigger time, echo, stack.
inline constexpr std::size_t phaseKeyCount = 6;

/// One image of a DICOM series: a file, or a frame of a file.
struct SliceRecord {
    std::string path;
    int frame = 0;
    Eigen::Vector2i size = Eigen::Vector2i::Zero();   ///< columns, rows
    Eigen::Vector2d spacingMm = Eigen::Vector2d::Zero();   ///< along a row, along a column
    double statedStepMm = 0.0;   ///< Spacing Between Slices; 0: absent
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

/// The images of one DICOM file and the file's series attributes.
struct DicomImages {
    core::StudyIdentity identity;
    std::string seriesDescription;
    int seriesNumber = 0;
    std::string sopClassUid;
    bool isProjection = false;   ///< an X-ray projection, not a slice
    std::optional<core::Message> damage;
    std::vector<SliceRecord> slices;   ///< empty: the file holds no image
};

struct DicomFile;

/// Returns the images that a parsed file describes.
DicomImages imagesOf(const DicomFile& file, const std::string& path);

/// Reads the header of a DICOM file, classic or enhanced multi-frame (functional groups). Fails as `openInput` does,
/// and on files that are not DICOM.
core::Result<DicomImages> readSliceRecords(const std::string& path);

}   // namespace angiopose::io