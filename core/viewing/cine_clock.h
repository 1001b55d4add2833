#pragma once

namespace angiopose::core {

/// Frames of a run, both ends included.
struct FrameRange {
    int first = 0;
    int last = 0;

    int count() const { return last - first + 1; }
    bool contains(int frame) const { return frame >= first && frame <= last; }
    bool operator==(const FrameRange&) const = default;
};

enum class CineOrder { Loop, BackAndForth };

/// Which frame of a playing run is due. It goes by the time alone: where showing takes too long, frames are left out,
/// and none comes late. Times in ms, of any clock that never goes back.
class CineClock {
public:
    /// `frameMs` > 0 is how long each frame stays.
    CineClock(const FrameRange& range, CineOrder order, double frameMs);

    /// From `frame` on; from the first of the range where it lies outside.
    void start(int frame, double nowMs);

    int frameAt(double nowMs) const;
    double untilNextMs(double nowMs) const;   ///< above 0

private:
    long stepsUntil(double nowMs) const;

    FrameRange range_;
    CineOrder order_;
    double frameMs_;
    int startFrame_;
    double startMs_ = 0.0;
};

}   // namespace angiopose::core
