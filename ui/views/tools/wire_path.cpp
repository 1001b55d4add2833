#include "ui/views/tools/wire_path.h"

namespace angiopose::ui {

void LiveWirePath::clear()
{
    segments_.clear();
    preview_.clear();
}

LiveWirePath::Points LiveWirePath::segmentTo(const Eigen::Vector2d& pointPx, core::LiveWire* liveWire,
                                             bool straight) const
{
    Points path{segments_.back().back(), pointPx};
    if (liveWire && !straight) {
        path = liveWire->pathTo(pointPx);
        path.insert(path.begin(), segments_.back().back());   // the live wire starts at the strongest response
    }
    return path;
}

void LiveWirePath::addAnchor(const Eigen::Vector2d& pointPx, core::LiveWire* liveWire, bool straight)
{
    segments_.push_back(segments_.empty() ? Points{pointPx} : segmentTo(pointPx, liveWire, straight));
    preview_.clear();
    if (liveWire) {
        liveWire->setAnchor(segments_.back().back());
        if (segments_.size() == 1 && !straight) {
            const Points start = liveWire->pathTo(pointPx);
            segments_.back() = {start.front()};
        }
    }
}

void LiveWirePath::undoStep(core::LiveWire* liveWire)
{
    if (segments_.empty()) {
        return;
    }
    segments_.pop_back();
    preview_.clear();
    if (liveWire && !segments_.empty()) {
        liveWire->setAnchor(segments_.back().back());
    }
}

void LiveWirePath::previewTo(const Eigen::Vector2d& pointPx, core::LiveWire* liveWire, bool straight)
{
    preview_ = segments_.empty() ? Points{} : segmentTo(pointPx, liveWire, straight);
}

LiveWirePath::Points LiveWirePath::points() const
{
    Points all;
    for (const Points& piece : segments_) {
        for (const Eigen::Vector2d& point : piece) {
            if (all.empty() || (point - all.back()).norm() > 1e-6) {
                all.push_back(point);
            }
        }
    }
    return all;
}

LiveWirePath::Points LiveWirePath::anchors() const
{
    Points ends;
    for (const Points& piece : segments_) {
        ends.push_back(piece.back());
    }
    return ends;
}

}   // namespace angiopose::ui
