#include "io/dicom/heart_beats.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace angiopose::io {
namespace {

constexpr DicomTag frameTimeVector = 0x00181065;
constexpr DicomTag rWaveTimeVector = 0x00186060;
constexpr DicomTag rWavePointer = 0x00286040;
constexpr std::size_t maxBeats = 10000;   // limit that protects against damaged headers

/// Returns the start time of each frame relative to the first frame, ms; empty if the frame times are unknown.
std::vector<double> frameStartsMs(const DicomDataset& data, int frameCount, double frameTimeMs)
{
    const bool isListed = data.number(frameTimeVector, static_cast<std::size_t>(frameCount) - 1).has_value();
    if (!isListed && frameTimeMs <= 0.0) {
        return {};
    }
    std::vector<double> starts{0.0};
    for (int frame = 1; frame < frameCount; ++frame) {
        const auto step = isListed ? data.number(frameTimeVector, static_cast<std::size_t>(frame)) : std::nullopt;
        starts.push_back(starts.back() + std::max(0.0, step.value_or(frameTimeMs)));
    }
    return starts;
}

int nearestFrame(const std::vector<double>& startsMs, double timeMs)
{
    const auto distance = [timeMs](double startMs) { return std::abs(startMs - timeMs); };
    return static_cast<int>(std::distance(startsMs.begin(), std::ranges::min_element(startsMs, {}, distance)));
}

std::vector<int> framesOfTimes(const DicomDataset& data, int frameCount, double frameTimeMs)
{
    std::vector<int> frames;
    const std::vector<double> startsMs = frameStartsMs(data, frameCount, frameTimeMs);
    const double endMs = startsMs.empty() ? 0.0 : startsMs.back() + frameTimeMs;
    for (std::size_t beat = 0; beat < maxBeats && !startsMs.empty(); ++beat) {
        const auto timeMs = data.number(rWaveTimeVector, beat);
        if (!timeMs) {
            break;
        }
        if (*timeMs >= 0.0 && *timeMs <= endMs) {
            frames.push_back(nearestFrame(startsMs, *timeMs));
        }
    }
    return frames;
}

}   // namespace

std::vector<int> rWaveFramesOf(const DicomDataset& data, int frameCount, double frameTimeMs)
{
    std::vector<int> frames;
    for (std::size_t beat = 0; beat < maxBeats; ++beat) {
        const auto number = data.integer(rWavePointer, beat);
        if (!number) {
            break;
        }
        if (*number >= 1 && *number <= frameCount) {
            frames.push_back(*number - 1);
        }
    }
    if (frames.empty() && frameCount > 0) {
        frames = framesOfTimes(data, frameCount, frameTimeMs);
    }
    std::ranges::sort(frames);
    frames.erase(std::unique(frames.begin(), frames.end()), frames.end());
    return frames;
}

}   // namespace angiopose::io
