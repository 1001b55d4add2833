#include "ui/views/tools/wire_path.h"

namespace angiopose::ui {

void WirePath::clear()
{
    segments_.clear();
    preview_.clear();
}

WirePath::Points WirePath::wayTo(const Eigen::Vector2d& pointPx, core::LiveWire* wire, bool straight) const
{
    Points path{segments_.back().back(), pointPx};
    if (wire && !straight) {
        path = wire->pathTo(pointPx);
        path.insert(path.begin(), segments_.back().back());   // the live wire starts at the strongest response
    }
    return path;
}

void WirePath::add(const Eigen::Vector2d& pointPx, core::LiveWire* wire, bool straight)
{
    segments_.push_back(segments_.empty() ? Points{pointPx} : wayTo(pointPx, wire, straight));
    preview_.clear();
    if (wire) {
        wire->setAnchor(segments_.back().back());
        if (segments_.size() == 1 && !straight) {
            const Points start = wire->pathTo(pointPx);
            segments_.back() = {start.front()};
        }
    }
}

void WirePath::undoStep(core::LiveWire* wire)
{
    if (segments_.empty()) {
        return;
    }
    segments_.pop_back();
    preview_.clear();
    if (wire && !segments_.empty()) {
        wire->setAnchor(segments_.back().back());
    }
}

void WirePath::previewTo(const Eigen::Vector2d& pointPx, core::LiveWire* wire, bool straight)
{
    preview_ = segments_.empty() ? Points{} : wayTo(pointPx, wire, straight);
}

WirePath::Points WirePath::points() const
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

WirePath::Points WirePath::anchors() const
{
    Points ends;
    for (const Points& piece : segments_) {
        ends.push_back(piece.back());
    }
    return ends;
}

}   // namespace angiopose::ui
