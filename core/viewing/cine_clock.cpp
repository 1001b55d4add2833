#include "core/viewing/cine_clock.h"

#include <algorithm>
#include <cmath>

namespace angiopose::core {

CineClock::CineClock(const FrameRange& range, CineOrder order, double frameMs)
    : range_(range), order_(order), frameMs_(frameMs), startFrame_(range.first)
{
}

void CineClock::start(int frame, double nowMs)
{
    startFrame_ = range_.contains(frame) ? frame : range_.first;
    startMs_ = nowMs;
}

long CineClock::stepsUntil(double nowMs) const
{
    return std::lround(std::floor(std::max(0.0, nowMs - startMs_) / frameMs_));
}

int CineClock::frameAt(double nowMs) const
{
    const long count = range_.count();
    const long step = startFrame_ - range_.first + stepsUntil(nowMs);
    if (order_ == CineOrder::Loop || count < 2) {
        return range_.first + static_cast<int>(step % count);
    }
    const long turn = 2 * (count - 1);   // period of forward and backward playback, in which neither end is shown twice
    const long place = step % turn;
    return range_.first + static_cast<int>(std::min(place, turn - place));
}

double CineClock::msUntilNextFrame(double nowMs) const
{
    const double next = startMs_ + static_cast<double>(stepsUntil(nowMs) + 1) * frameMs_;
    return std::max(next - nowMs, 0.01 * frameMs_);   // positive in spite of rounding, to keep the playback running
}

}   // namespace angiopose::core
