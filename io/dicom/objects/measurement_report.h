#pragma once

#include "io/dicom/objects/coded_term.h"
#include "io/dicom/objects/derived_object.h"

#include <Eigen/Core>
#include <string>
#include <vector>

namespace angiopose::io {

/// Measured value with the points at which it was measured, in the image or in the patient, if any.
struct ReportNumber {
    CodedTerm meaning;
    double value = 0.0;
    CodedTerm unit;
    int frame = 0;
    std::vector<Eigen::Vector2d> pixels = {};   ///< image points, px; (0, 0) is the center of the first pixel
    std::vector<Eigen::Vector3d> pointsInPatient = {};   ///< patient points, LPS mm
};

struct ReportText {
    CodedTerm meaning;
    std::string words;
};

/// Group of related values: a single measurement, or all values of a registration.
struct ReportGroup {
    std::string name;   ///< display name
    std::vector<ReportNumber> numbers;
    std::vector<ReportText> texts = {};
};

struct MeasurementReport {
    std::vector<ReportGroup> groups;
    std::string scanFrameOfReferenceUid;   ///< frame of reference UID of `pointsInPatient`
};

/// Returns the measurements of an image and its scan as a Comprehensive 3D SR that follows TID 1500 (PS3.16). Fails if
/// there are no measurements.
core::Result<std::string> encodeMeasurementReport(const MeasurementReport& report, const SourceImage& source,
                                                  const ObjectOrigin& origin);

inline constexpr CodedTerm lengthTerm{"410668003", "SCT", "Length"};
inline constexpr CodedTerm angleTerm{"1483009", "SCT", "Angle"};
inline constexpr CodedTerm areaTerm{"42798000", "SCT", "Area"};

}   // namespace angiopose::io
