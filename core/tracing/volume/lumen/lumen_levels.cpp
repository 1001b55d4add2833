#include "core/tracing/volume/lumen/lumen_levels.h"

#include "core/messages/messages.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace angiopose::core {
namespace {

constexpr std::size_t levelBins = 300;
constexpr int coarseStep = 3;   ///< sampling step in voxels, along each axis
constexpr double maxAirHu = -500.0;   ///< a lowest value below this indicates CT in HU
constexpr double airLevelHu = -1000.0;
constexpr double darkHu = -20.0;   ///< fat is darker; on unsigned scales (air at 0), only noise is this dark
constexpr double minDarkFraction = 0.001;   ///< minimum fraction of voxels at or below `darkHu`
constexpr double denseHu = 800.0;   ///< bone and metal; for HU shifted by about 1000 (air at 0), the whole body
constexpr double maxDenseFraction = 0.2;   ///< maximum fraction of voxels above `denseHu`
constexpr double minContrastHu = 150.0;   ///< minimum lumen contrast to tissue in CT; organs and marrow have less
constexpr double minContrastFraction = 0.15;   ///< without HU: fraction of the tissue-to-bone range (about 1000 HU)
constexpr double minBloodMl = 0.03;
constexpr double minRelativePeak = 0.01;   ///< minimum volume of a peak relative to the largest peak
constexpr double airFraction = 0.05;   ///< fraction of the value range, from the lowest value, that counts as air
constexpr double minBodyFraction = 0.05;   ///< minimum volume relative to air; vessels alone have less
constexpr double minMuscleFraction = 0.2;   ///< minimum volume relative to the largest body peak, which may be fat
constexpr double maxChangeFraction = 0.04;   ///< maximum change in homogeneous regions, fraction of the value range

constexpr int brightStep = 2;   ///< sampling step in voxels when searching for the brightest voxels
constexpr double brightestMl = 0.5;   ///< volume of 10 mm of a common carotid artery
constexpr double maxAirFraction = 0.08;   ///< maximum air level, fraction of the range from lowest value to lumen
constexpr double minLumenToTissue = 1.5;   ///< minimum ratio of lumen to tissue level

/// Smoothed histogram of the voxels with homogeneous surroundings.
struct Histogram {
    double low = 0.0;
    double binWidth = 1.0;
    std::vector<double> ml = std::vector<double>(levelBins, 0.0);

    double valueOf(std::size_t bin) const { return low + binWidth * (static_cast<double>(bin) + 0.5); }
};

/// Reads values in patient axis order.
class VoxelReader {
public:
    VoxelReader(const Volume& volume, const AxisOrder& order) : volume_(volume), order_(order) {}

    double at(int i, int j, int k) const { return volume_.value(order_.stored(i, j, k)); }

    /// Returns the mean over a voxel and its six neighbors, which reduces noise.
    double mean(int i, int j, int k) const
    {
        return (at(i, j, k) + at(i - 1, j, k) + at(i + 1, j, k) + at(i, j - 1, k) + at(i, j + 1, k) + at(i, j, k - 1) +
                at(i, j, k + 1)) /
               7.0;
    }

    /// Returns the largest difference from the surroundings two voxels away.
    double change(int i, int j, int k, double center) const
    {
        double greatest = 0.0;
        for (const int step : {-2, 2}) {
            greatest = std::max({greatest, std::abs(mean(i + step, j, k) - center),
                                 std::abs(mean(i, j + step, k) - center), std::abs(mean(i, j, k + step) - center)});
        }
        return greatest;
    }

    template <class Visit>
    void visit(int rim, int step, const Visit& visitor) const
    {
        const Eigen::Vector3i& size = order_.geometry.size;
        for (int k = rim; k < size.z() - rim; k += step) {
            for (int j = rim; j < size.y() - rim; j += step) {
                for (int i = rim; i < size.x() - rim; i += step) {
                    visitor(i, j, k);
                }
            }
        }
    }

    double voxelMl() const { return order_.geometry.spacingMm.prod() / 1000.0; }

private:
    const Volume& volume_;
    const AxisOrder& order_;
};

struct Range {
    double low = 0.0;   ///< lowest value; in HU at most that of air, even without air in the scan
    double high = 0.0;   ///< 99.8th percentile of the sampled values
    bool isHu = false;
};

/// Returns whether the values are Hounsfield units: the scan contains air, or (if cropped) fat and only few voxels as
/// dense as the whole body would be if HU were shifted above 0.
bool isHounsfield(std::vector<float>& values, double low)
{
    const auto dark =
        values.begin() + static_cast<std::ptrdiff_t>(minDarkFraction * static_cast<double>(values.size()));
    std::nth_element(values.begin(), dark, values.end());
    const auto dense = std::count_if(values.begin(), values.end(), [](float value) { return value > denseHu; });
    return low < maxAirHu ||
           (*dark < darkHu && static_cast<double>(dense) < maxDenseFraction * static_cast<double>(values.size()));
}

Range measureRange(const VoxelReader& reader)
{
    std::vector<float> values;
    reader.visit(0, coarseStep, [&](int i, int j, int k) { values.push_back(static_cast<float>(reader.at(i, j, k))); });
    if (values.empty()) {
        return {};
    }
    const auto top = values.begin() + static_cast<std::ptrdiff_t>(0.998 * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), top, values.end());
    const double high = *top;
    const double low = *std::min_element(values.begin(), values.end());
    const bool isHu = isHounsfield(values, low);
    return {isHu ? std::min(low, airLevelHu) : low, high, isHu};
}

/// Computes the histogram of the voxels above a value, sampling every `step`-th voxel along each axis.
Histogram histogramOf(const VoxelReader& reader, const Range& range, double above, int step)
{
    Histogram histogram;
    histogram.low = range.low;
    histogram.binWidth = (1.5 * (range.high - range.low)) / levelBins;   // covers small bright lumens beyond the range
    reader.visit(3, step, [&](int i, int j, int k) {
        if (reader.at(i, j, k) <= above) {
            return;
        }
        const double center = reader.mean(i, j, k);
        const double bin = (center - histogram.low) / histogram.binWidth;
        if (bin >= 0.0 && bin < levelBins &&
            reader.change(i, j, k, center) < maxChangeFraction * (range.high - range.low)) {
            histogram.ml[static_cast<std::size_t>(bin)] += reader.voxelMl() * step * step * step;
        }
    });
    for (int round = 0; round < 3; ++round) {   // approximates a Gaussian with σ = 2.4 bins
        std::vector<double> smooth(levelBins, 0.0);
        for (std::size_t b = 0; b < levelBins; ++b) {
            for (std::size_t n = b < 2 ? 0 : b - 2; n <= std::min(levelBins - 1, b + 2); ++n) {
                smooth[b] += histogram.ml[n] / 5.0;
            }
        }
        histogram.ml = std::move(smooth);
    }
    return histogram;
}

struct Peak {
    std::size_t bin = 0;
    double ml = 0.0;   ///< volume between the adjacent valleys
};

std::vector<Peak> findPeaks(const Histogram& histogram, double above)
{
    std::vector<Peak> peaks;
    for (std::size_t b = 3; b + 3 < levelBins; ++b) {
        const auto around = histogram.ml.begin() + static_cast<std::ptrdiff_t>(b);
        const bool isPeak = *around > 0.0 && *around >= *std::max_element(around - 3, around + 4);
        if (!isPeak || histogram.valueOf(b) < above || (!peaks.empty() && peaks.back().bin + 3 >= b)) {
            continue;
        }
        Peak peak{b, histogram.ml[b]};
        for (std::size_t n = b; n-- > 0 && histogram.ml[n] <= histogram.ml[n + 1];) {
            peak.ml += histogram.ml[n];
        }
        for (std::size_t n = b + 1; n < levelBins && histogram.ml[n] <= histogram.ml[n - 1]; ++n) {
            peak.ml += histogram.ml[n];
        }
        peaks.push_back(peak);
    }
    return peaks;
}

std::size_t highestBin(const Histogram& histogram, double above, double below)
{
    std::size_t best = 0;
    for (std::size_t b = 0; b < levelBins; ++b) {
        const bool isCandidate = histogram.valueOf(b) > above && histogram.valueOf(b) < below;
        if (isCandidate && (histogram.ml[b] > histogram.ml[best] || best == 0)) {
            best = b;
        }
    }
    return best;
}

/// Returns the tissue level without Hounsfield units: the highest peak or, if that is the air around the patient, the
/// brightest peak large enough for muscle and organs (fat is darker; vessels and bone have less volume).
double tissueWithoutHu(const Histogram& histogram, const Range& range)
{
    const std::size_t highest = highestBin(histogram, range.low - 1.0, std::numeric_limits<double>::max());
    const double maxAir = range.low + airFraction * (range.high - range.low);
    if (histogram.valueOf(highest) > maxAir) {
        return histogram.valueOf(highest);
    }
    double airMl = 0.0;
    for (std::size_t b = 0; b < levelBins && histogram.valueOf(b) <= maxAir; ++b) {
        airMl += histogram.ml[b];
    }
    const std::vector<Peak> peaks = findPeaks(histogram, maxAir);
    double minMl = minBodyFraction * airMl;
    for (const Peak& peak : peaks) {
        minMl = std::max(minMl, minMuscleFraction * peak.ml);
    }
    const auto muscle = std::find_if(peaks.rbegin(), peaks.rend(), [&](const Peak& peak) { return peak.ml >= minMl; });
    const bool isBelowBlood = muscle != peaks.rend() && muscle != peaks.rbegin();
    return histogram.valueOf(isBelowBlood ? muscle->bin : highest);
}

/// Returns the tissue level: in CT, the highest peak of muscle and organs.
double tissueValue(const Histogram& histogram, const Range& range, bool isHu)
{
    return isHu ? histogram.valueOf(highestBin(histogram, 0.0, 130.0)) : tissueWithoutHu(histogram, range);
}

/// Returns the median of the values above the threshold.
double medianAbove(const VoxelReader& reader, double threshold)
{
    std::vector<float> values;
    reader.visit(0, coarseStep, [&](int i, int j, int k) {
        if (const double value = reader.at(i, j, k); value > threshold) {
            values.push_back(static_cast<float>(value));
        }
    });
    if (values.empty()) {
        return threshold;
    }
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

/// Returns the value above which the sampled voxels have a total volume of `ml`.
double thresholdForVolume(std::vector<float>& values, double ml, double mlPerSample)
{
    const auto count =
        static_cast<std::ptrdiff_t>(std::min(ml / mlPerSample, static_cast<double>(values.size()) - 1.0));
    const auto at = values.end() - 1 - count;
    std::nth_element(values.begin(), at, values.end());
    return *at;
}

/// Returns the mode of the values between `low` and `high`.
double findMode(const std::vector<float>& values, double low, double high)
{
    constexpr std::size_t bins = 60;
    std::array<double, bins + 2> counts{};
    for (const float value : values) {
        const double bin = (value - low) / (high - low) * bins;
        if (bin >= 0.0 && bin < bins) {
            counts[static_cast<std::size_t>(bin) + 1] += 1.0;
        }
    }
    std::size_t best = 1;
    const auto around = [&](std::size_t n) { return counts[n - 1] + counts[n] + counts[n + 1]; };
    for (std::size_t n = 1; n <= bins; ++n) {
        best = around(n) > around(best) ? n : best;
    }
    return low + (static_cast<double>(best) - 0.5) * (high - low) / bins;
}

Quantity scanValue(double value, bool isHu)
{
    return {value, 0, isHu ? "HU" : ""};
}

}   // namespace

Error noVesselsError(const LumenLevels& level)
{
    return messages::brightestIsNoVessel(scanValue(level.blood, level.isHu), scanValue(level.tissue, level.isHu));
}

bool isInHounsfield(const Volume& volume, const AxisOrder& order)
{
    return measureRange(VoxelReader(volume, order)).isHu;
}

Result<LumenLevels> findLumenLevels(const Volume& volume, const AxisOrder& order, const LumenLevelSearch& search)
{
    const std::optional<double>& threshold = search.threshold;
    const VoxelReader reader(volume, order);
    const Range range = measureRange(reader);
    if (!(range.high > range.low)) {
        return Error(messages::volumeOfOneValue());
    }
    const bool isHu = range.isHu;
    LumenLevels level;
    level.isHu = isHu;
    level.tissue = tissueValue(histogramOf(reader, range, range.low - 1.0, coarseStep), range, isHu);
    const double minBlood =
        threshold ? *threshold
                  : level.tissue + (isHu ? minContrastHu : minContrastFraction * (range.high - level.tissue));
    // Samples every voxel, because the opacified lumen may be small.
    const Histogram histogram = histogramOf(reader, range, minBlood, 1);
    const std::vector<Peak> peaks = findPeaks(histogram, minBlood);
    double greatest = minBloodMl;
    for (const Peak& peak : peaks) {
        greatest = histogram.valueOf(peak.bin) <= search.maxBlood ? std::max(greatest, peak.ml) : greatest;
    }
    const auto found = std::find_if(peaks.rbegin(), peaks.rend(), [&](const Peak& peak) {
        return peak.ml >= std::max(minBloodMl, minRelativePeak * greatest) &&
               histogram.valueOf(peak.bin) <= search.maxBlood;
    });
    if (found == peaks.rend() && !threshold) {
        return Error(messages::noContrast(scanValue(level.tissue, isHu)));
    }
    level.blood = found != peaks.rend() ? histogram.valueOf(found->bin) : medianAbove(reader, *threshold);
    level.threshold = threshold ? *threshold : 0.5 * (level.tissue + level.blood);
    if (threshold) {
        level.blood = std::max(level.blood, *threshold + 1e-6);
        level.tissue = 2.0 * *threshold - level.blood;
    }
    return level;
}

Result<LumenLevels> findBrightestLevels(const Volume& volume, const AxisOrder& order)
{
    const VoxelReader reader(volume, order);
    std::vector<float> values;
    reader.visit(1, brightStep,
                 [&](int i, int j, int k) { values.push_back(static_cast<float>(reader.mean(i, j, k))); });
    if (values.empty()) {
        return Error(messages::volumeOfOneValue());
    }
    const double mlPerSample = reader.voxelMl() * brightStep * brightStep * brightStep;
    LumenLevels level;
    level.blood = thresholdForVolume(values, brightestMl, mlPerSample);
    const double low = *std::min_element(values.begin(), values.end());
    level.tissue = findMode(values, low + maxAirFraction * (level.blood - low), level.blood);
    level.threshold = 0.5 * (level.tissue + level.blood);
    if (level.blood - low < minLumenToTissue * (level.tissue - low)) {
        return Error(messages::noContrast(scanValue(level.tissue, false)));
    }
    return level;
}

}   // namespace angiopose::core
