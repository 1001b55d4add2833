#pragma once

#include "core/imaging/volume.h"
#include "core/vessel/vessel_tree.h"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace angiopose::core {

/// Scans as they come, in which a program without a seed must find the great vessel or ask.
enum class ScanKind {
    HeadCta,   ///< arteries alone well filled, sinuses half
    HeadCtaLate,   ///< sinuses and jugular veins filled as the arteries
    HeadCtaMalformation,   ///< the same, and a nidus joins an artery to the sagittal sinus
    HeadCtaAboveBase,   ///< late, cropped above the base of the skull
    HeadCtaThick,   ///< late, slices of 3 to 5 mm
    HeadTof,   ///< MR, time of flight: inflow from below alone is bright, the skull dark
    HeadTofSlab,   ///< the same, 70 mm about the circle of Willis
    BodyMra,   ///< MR with contrast medium, aorta from the arch on, strong fall-off of the coil along the body
    LegMra,   ///< the same, from the aorta's end to the popliteal arteries
    HeadRotational,   ///< rotational angiography: one carotid filled, cone-beam artefacts, round truncated field
    AbdomenThick,   ///< CT, slices of 3 to 5 mm
    AbdomenGray,   ///< CT whose values are no Hounsfield units
    ThoraxCropped,   ///< CT, faces cut through heart and aorta
};

/// A name for tables, and the kind.
struct NamedScanKind {
    const char* name;
    ScanKind kind;
};

std::span<const NamedScanKind> allScanKinds();

/// From which ranges a scan's noise, resolution, contrast, fall-off, size and side are drawn: those for choosing
/// constants are narrower than those for judging them, and no seed gives the same in both.
enum class ScanRanges { Choosing, Judging };

struct AnyScan {
    Volume volume;
    VesselTree arteries;   ///< all that are filled, also beyond the scan's faces
    VesselTree upstream;   ///< the left ventricle, which the aorta comes from: no artery, and no wrong beginning
    VesselTree seen;   ///< stretches of the arteries whose axes lie in the scan
    std::vector<int> great;   ///< ids of arteries that may be begun at: aorta, carotids, iliac and femoral ones, …
};

/// Same arguments, same bits.
AnyScan simulateAnyScan(ScanKind kind, std::uint64_t seed, ScanRanges ranges);

}   // namespace angiopose::core
