#pragma once

#include "core/geometry/patient_position.h"

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

namespace angiopose::core {

/// A header element as it is written, for people to read.
struct HeaderTag {
    std::string tag;   ///< "(0018,1110)"
    std::string name;   ///< as PS3.6 has it: "Distance Source to Detector"
    std::string value;
};

/// Where the isocenter lies in the patient, whom the table carries past it. From an origin of the device's: only
/// differences between views of one stay tell something.
struct TablePosition {
    enum class Tags { Standard, Siemens };   ///< each with an origin of its own

    Eigen::Vector3d isocenterInPatientMm;   ///< LPS
    Tags tags = Tags::Standard;
};

/// An image of one of two planes that were taken together.
struct BiplaneMoment {
    char plane;   ///< 'A' or 'B'
    std::string date;   ///< yyyymmdd
    double timeS;   ///< since midnight
};

/// What the header of an X-ray run says about the gantry beside the values a CArm holds: facts to check those against,
/// and to show. Lengths mm, angles degrees.
struct GantryHeader {
    std::optional<double> magnification;   ///< (0018,1114) estimated radiographic magnification, SID/SOD
    std::optional<Eigen::Vector2d> fieldOfViewMm;   ///< (0018,1149) on the detector: width, height; round: diameters
    std::optional<double> intensifierMm;   ///< (0018,1162) diameter of the image intensifier
    std::optional<Eigen::Vector2d> detectorMm;   ///< (0018,7026) active area: width, height
    std::optional<Eigen::Vector2d> pixelSpacingMm;   ///< (0028,0030) along u, v: at the patient, where it is calibrated
    bool isPixelSpacingCalibrated = false;   ///< (0028,0A02) says how; otherwise it should repeat the imager's
    double pixelAspect = 1.0;   ///< (0028,0034) height of a pixel over its width
    /// (0018,1520), (0018,1521): primary and secondary angle of each frame relative to the first; empty when it stood.
    std::vector<Eigen::Vector2d> angleIncrementsDeg;
    std::optional<PatientPosition> patientPosition;   ///< (0018,5100); angles refer to the patient whatever it is
    std::optional<TablePosition> table;   ///< (0018,9466–9468), or what a room's private tags say
    bool tableMoves = false;   ///< during the run: it is nowhere in particular
    std::optional<BiplaneMoment> biplane;   ///< (0008,0008) BIPLANE A or B
    std::vector<HeaderTag> tags;   ///< every element about geometry that is there, in the order of the tags
};

}   // namespace angiopose::core