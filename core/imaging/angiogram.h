#pragma once

#include "core/geometry/c_arm.h"
#include "core/geometry/gantry_header.h"
#include "core/imaging/image2d.h"
#include "core/support/message.h"

#include <map>
#include <string>
#include <vector>

namespace angiopose::core {

enum class Polarity { VesselsDark, VesselsBright };

/// Patient and study data from the header; every field may be empty. The data are never written to logs.
struct StudyIdentity {
    std::string patientName;
    std::string patientId;
    std::string birthDate;   ///< yyyy-mm-dd
    std::string sex;
    std::string accessionNumber;   ///< accession number of the imaging request
    std::string laterality;   ///< "L" or "R" of a paired body part
    std::string institution;
    std::string studyDate;   ///< yyyy-mm-dd
    std::string studyTime;   ///< hh:mm
    std::string modality;
    std::string manufacturer;
    std::string description;
    std::string studyUid;
    std::string seriesUid;
    std::string sopInstanceUid;
};

/// An X-ray run: frames of equal size, with the stored values as float, and the geometry from the header.
struct Angiogram {
    std::vector<ImageF> frames;
    Polarity polarity = Polarity::VesselsDark;
    double frameTimeMs = 0.0;   ///< 0 if unknown or for a single frame
    std::vector<int> rWaveFrames;   ///< frames at the R waves of the ECG, ascending; empty if the header gives none
    int suggestedFrame = 0;   ///< peak-opacification frame: the frame with the most vessel-like pixels
    CArm cArm;
    GantryHeader gantry;
    StudyIdentity identity;
    Mask2d shutter;   ///< 255 inside the display shutter of the header, (0018,1600); empty if there is none
    Messages warnings;   ///< for example that a color image was converted to gray

    int width() const { return frames.empty() ? 0 : frames.front().width; }
    int height() const { return frames.empty() ? 0 : frames.front().height; }
    int frameCount() const { return static_cast<int>(frames.size()); }
};

}   // namespace angiopose::core
