#pragma once

#include "core/tracing/angiogram/drawing/live_wire.h"

#include <vector>

namespace angiopose::ui {

/// A path drawn from anchor to anchor, following vessels between them.
class WirePath {
public:
    using Points = std::vector<Eigen::Vector2d>;

    bool isEmpty() const { return pieces_.empty(); }
    void clear();

    /// Another anchor. Without a wire, or where `straight` is asked for, by the straight way.
    void add(const Eigen::Vector2d& pointPx, core::LiveWire* wire, bool straight);
    void takeBack(core::LiveWire* wire);   ///< the last anchor
    void aim(const Eigen::Vector2d& pointPx, core::LiveWire* wire, bool straight);   ///< where the next one might be

    Points points() const;   ///< without the aim
    Points anchors() const;
    const Points& aimed() const { return aimed_; }

private:
    Points wayTo(const Eigen::Vector2d& pointPx, core::LiveWire* wire, bool straight) const;

    std::vector<Points> pieces_;   ///< the first holds the first anchor alone; each ends in an anchor
    Points aimed_;
};

}   // namespace angiopose::ui