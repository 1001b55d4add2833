#include "io/dicom/frame_time.h"

#include "io/messages/messages.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace angiopose::io {
namespace {

constexpr DicomTag incrementPointerTag = 0x00280009;
constexpr DicomTag timeTag = 0x00181063;
constexpr DicomTag vectorTag = 0x00181065;
constexpr std::size_t maxFrames = 20'000;

double positiveOrZero(const DicomDataset& data, DicomTag tag)
{
    return std::max(data.number(tag).value_or(0.0), 0.0);
}

/// Returns the median interval of Frame Time Vector; skips the first value, which precedes the first frame.
double medianOfVector(const DicomDataset& data)
{
    std::vector<double> steps;
    for (std::size_t k = 1; k < maxFrames; ++k) {
        const auto step = data.number(vectorTag, k);
        if (!step) {
            break;
        }
        if (*step > 0.0) {
            steps.push_back(*step);
        }
    }
    std::ranges::sort(steps);
    return steps.empty() ? 0.0 : steps[steps.size() / 2];
}

}   // namespace

FrameTime frameTimeOf(const DicomDataset& data)
{
    const double single = positiveOrZero(data, timeTag), median = medianOfVector(data);
    const bool isVector = data.integer(incrementPointerTag) == static_cast<int>(vectorTag);
    FrameTime time{(isVector && median > 0.0) || single == 0.0 ? median : single, {}};
    if (single > 0.0 && median > 0.0 && std::abs(single - median) > 0.05 * time.ms) {
        time.contradiction = messages::dicomFrameTimes(core::Quantity{single, 1, "ms"}, core::Quantity{median, 1, "ms"},
                                                       core::Quantity{time.ms, 1, "ms"});
    }
    for (const DicomTag rate : {DicomTag{0x00180040}, DicomTag{0x00082144}}) {
        time.ms = time.ms == 0.0 && positiveOrZero(data, rate) > 0.0 ? 1000.0 / positiveOrZero(data, rate) : time.ms;
    }
    return time;
}

}   // namespace angiopose::io
