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

/// Patient and study data from the header; every field may be empty. Never written to logs.
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

/// One X-ray run: frames of equal size, stored values as float, with the geometry its header gives.
struct Angiogram {
    std::vector<ImageF> frames;
    Polarity polarity = Polarity::VesselsDark;
    double frameTimeMs = 0.0;   ///< 0 when unknown or a single frame
    std::vector<int> rWaveFrames;   ///< those at the R waves of the ECG, ascending; empty when the header has none
    int suggestedFrame = 0;   ///< peak-opacification frame: most vessel-like pixels
    CArm cArm;
    GantryHeader gantry;
    StudyIdentity identity;
    Mask2d shutter;   ///< 255 inside the display shutter of the header, (0018,1600); empty: it has none
    Messages warnings;   ///< e.g. that a colour image was converted to grey

    int width() const { return frames.empty() ? 0 : frames.front().width; }
    int height() const { return frames.empty() ? 0 : frames.front().height; }
    int frameCount() const { return static_cast<int>(frames.size()); }
};

}   // namespace angiopose::core
