#include "ui/views/tools/wire_path.h"

namespace angiopose::ui {

void WirePath::clear()
{
    pieces_.clear();
    aimed_.clear();
}

WirePath::Points WirePath::wayTo(const Eigen::Vector2d& pointPx, core::LiveWire* wire, bool straight) const
{
    Points way{pieces_.back().back(), pointPx};
    if (wire && !straight) {
        way = wire->pathTo(pointPx);
        way.insert(way.begin(), pieces_.back().back());   // the live wire starts at the strongest response
    }
    return way;
}

void WirePath::add(const Eigen::Vector2d& pointPx, core::LiveWire* wire, bool straight)
{
    pieces_.push_back(pieces_.empty() ? Points{pointPx} : wayTo(pointPx, wire, straight));
    aimed_.clear();
    if (wire) {
        wire->setAnchor(pieces_.back().back());
        if (pieces_.size() == 1 && !straight) {
            const Points start = wire->pathTo(pointPx);
            pieces_.back() = {start.front()};
        }
    }
}

void WirePath::takeBack(core::LiveWire* wire)
{
    if (pieces_.empty()) {
        return;
    }
    pieces_.pop_back();
    aimed_.clear();
    if (wire && !pieces_.empty()) {
        wire->setAnchor(pieces_.back().back());
    }
}

void WirePath::aim(const Eigen::Vector2d& pointPx, core::LiveWire* wire, bool straight)
{
    aimed_ = pieces_.empty() ? Points{} : wayTo(pointPx, wire, straight);
}

WirePath::Points WirePath::points() const
{
    Points all;
    for (const Points& piece : pieces_) {
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
    for (const Points& piece : pieces_) {
        ends.push_back(piece.back());
    }
    return ends;
}

}   // namespace angiopose::ui
