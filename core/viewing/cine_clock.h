#pragma once

namespace angiopose::core {

/// A range of frames in a run, both ends included.
struct FrameRange {
    int first = 0;
    int last = 0;

    int count() const { return last - first + 1; }
    bool contains(int frame) const { return frame >= first && frame <= last; }
    bool operator==(const FrameRange&) const = default;
};

enum class CineOrder { Loop, BackAndForth };

/// Determines from the time alone which frame of a playing run to show. If the display is too slow, frames are skipped,
/// but none is shown late. Times are in ms, from any monotonic clock.
class CineClock {
public:
    /// `frameMs` is the duration of each frame and must be above 0.
    CineClock(const FrameRange& range, CineOrder order, double frameMs);

    /// Starts playback from `frame`, or from the first frame of the range if `frame` lies outside.
    void start(int frame, double nowMs);

    int frameAt(double nowMs) const;
    double msUntilNextFrame(double nowMs) const;   ///< time until the next frame is due; always above 0

private:
    long stepsUntil(double nowMs) const;

    FrameRange range_;
    CineOrder order_;
    double frameMs_;
    int startFrame_;
    double startMs_ = 0.0;
};

}   // namespace angiopose::core
