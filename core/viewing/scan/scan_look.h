#pragma once

#include "core/imaging/volume.h"

#include <array>
#include <optional>
#include <vector>

namespace angiopose::core {

/// sRGB, 0…1.
using Rgb = std::array<float, 3>;

/// How strongly values hide what is behind them: nothing below `from`, `perMm` from `full` on, between them linearly.
struct Opacity {
    double from = 0.0;   ///< in the scan's values (HU)
    double full = 1.0;
    double perMm = 0.0;

    double at(double value) const;
    bool operator==(const Opacity&) const = default;
};

/// How a scan is seen.
struct ScanLook {
    Opacity vessels;   ///< of what belongs to vessels
    Opacity rest;   ///< of all else
    double brightFrom = 0.0;   ///< all else goes from `soft` at its beginning to `bone` here
    Rgb soft{};
    Rgb bone{};
    std::vector<Rgb> kinds;   ///< of vessels, or of labels 1, 2, …; the last of all beyond

    bool operator==(const ScanLook&) const = default;
};

enum class ScanPreset { Vessels, VesselsAndBone };

/// What a preset depends on besides the scan.
struct ScanWish {
    ScanPreset preset = ScanPreset::Vessels;
    double strength = 0.5;   ///< 0…1, of all opacities together
    Rgb soft{};
    Rgb bone{};
    std::vector<Rgb> kinds;

    bool operator==(const ScanWish&) const = default;
};

/// What the values of a scan say about vessels, to be looked at: no more than that.
struct SeenLevels {
    double tissue = 0.0;
    double wall = 200.0;   ///< half way from tissue to blood
    double blood = 400.0;
    bool isHu = false;
};

/// The levels that tracing would find, or the threshold it was given; else, of MR and of what has no units, from the
/// scan's own histogram: a vessel is brighter than nearly all.
SeenLevels seenLevels(const Volume& volume, std::optional<double> threshold);

/// `hasKinds`: it is known where vessels are, so that all else can be told from them.
ScanLook lookOf(const SeenLevels& levels, const ScanWish& wish, bool hasKinds);

/// Of a mask without a scan.
ScanLook lookOfMask(const ScanWish& wish);

}   // namespace angiopose::core
