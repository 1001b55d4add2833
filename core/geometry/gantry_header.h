#pragma once

#include "core/geometry/patient_position.h"

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

namespace angiopose::core {

/// A header element as stored in the file, for display.
struct HeaderTag {
    std::string tag;   ///< tag in DICOM notation, such as "(0018,1110)"
    std::string name;   ///< name in PS3.6, such as "Distance Source to Detector"
    std::string value;
};

/// Position of the isocenter in the patient, who moves with the table. Its origin is device-specific: only differences
/// between images acquired without repositioning the patient are meaningful.
struct TablePosition {
    enum class Tags { Standard, Siemens };   ///< source of the position; each source has its own coordinate origin

    Eigen::Vector3d isocenterInPatientMm;   ///< LPS
    Tags tags = Tags::Standard;
};

/// Acquisition time of one of the two planes of a biplane acquisition.
struct BiplaneTime {
    char plane;   ///< 'A' or 'B'
    std::string date;   ///< yyyymmdd
    double timeS;   ///< seconds since midnight
};

/// Gantry data in the header of an X-ray run beyond those in CArm, for display and for checking the values in CArm.
/// Lengths are in mm, angles in degrees.
struct GantryHeader {
    std::optional<double> magnification;   ///< (0018,1114) estimated radiographic magnification, SID/SOD
    std::optional<Eigen::Vector2d> fieldOfViewMm;   ///< (0018,1149) on the detector: width, height; diameter if round
    std::optional<double> intensifierMm;   ///< (0018,1162) diameter of the image intensifier
    std::optional<Eigen::Vector2d> detectorMm;   ///< (0018,7026) active area of the detector: width, height
    std::optional<Eigen::Vector2d> pixelSpacingMm;   ///< (0028,0030) along u, v; refers to the patient if calibrated
    bool isPixelSpacingCalibrated = false;   ///< (0028,0A02) gives the method; otherwise equal to the imager spacing
    double pixelAspect = 1.0;   ///< (0028,0034) pixel height divided by pixel width
    /// (0018,1520), (0018,1521): primary and secondary angle of each frame relative to the first frame; empty if the
    /// gantry did not move.
    std::vector<Eigen::Vector2d> angleIncrementsDeg;
    std::optional<PatientPosition> patientPosition;   ///< (0018,5100); the angles always refer to the patient
    std::optional<TablePosition> table;   ///< (0018,9466–9468) or private vendor tags
    bool tableMoves = false;   ///< whether the table moves during the run, so that `table` is not a single position
    std::optional<BiplaneTime> biplane;   ///< (0008,0008) BIPLANE A or B
    std::vector<HeaderTag> tags;   ///< all geometry elements in the header, sorted by tag
};

}   // namespace angiopose::core
