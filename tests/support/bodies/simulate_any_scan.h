#pragma once

#include "core/imaging/volume.h"
#include "core/vessel/vessel_tree.h"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace angiopose::core {

/// Unselected kinds of scans, in which the program must find the great vessel without a seed or ask for one.
enum class ScanKind {
    HeadCta,   ///< fully enhanced arteries, half enhanced sinuses
    HeadCtaLate,   ///< sinuses and jugular veins enhanced as much as the arteries
    HeadCtaMalformation,   ///< as HeadCtaLate, with a nidus that connects an artery to the sagittal sinus
    HeadCtaAboveBase,   ///< late phase, cropped above the base of the skull
    HeadCtaThick,   ///< late phase, slices of 3 to 5 mm
    HeadTof,   ///< time-of-flight MR: only inflow from below is bright, the skull is dark
    HeadTofSlab,   ///< as HeadTof, 70 mm around the circle of Willis
    BodyMra,   ///< contrast-enhanced MR, aorta from the arch on, strong fall-off of the coil sensitivity along the body
    LegMra,   ///< as BodyMra, from the end of the aorta to the popliteal arteries
    HeadRotational,   ///< rotational angiography: one carotid artery opacified, cone-beam artifacts, round truncated
                      ///< field
    AbdomenThick,   ///< CT, slices of 3 to 5 mm
    AbdomenGray,   ///< CT whose values are not Hounsfield units
    ThoraxCropped,   ///< CT with faces that cut through the heart and the aorta
};

/// A kind of scan with its name in tables.
struct NamedScanKind {
    const char* name;
    ScanKind kind;
};

std::span<const NamedScanKind> allScanKinds();

/// Ranges for the random noise, resolution, contrast, fall-off, size and side of a scan: those for choosing constants
/// are narrower than those for evaluating them, and no seed gives the same scan in both.
enum class ScanRanges { Choosing, Judging };

struct AnyScan {
    Volume volume;
    VesselTree arteries;   ///< all enhanced arteries, including parts outside the scan
    VesselTree
        upstream;   ///< the left ventricle upstream of the aorta: not an artery, but not a wrong starting point either
    VesselTree seen;   ///< sections of the arteries whose axes lie inside the scan
    std::vector<int>
        great;   ///< ids of arteries allowed as starting points: aorta, carotid, iliac and femoral arteries, …
};

/// Deterministic: the same arguments give the same bits.
AnyScan simulateAnyScan(ScanKind kind, std::uint64_t seed, ScanRanges ranges);

}   // namespace angiopose::core
