#pragma once

#include "core/tracing/angiogram/drawing/live_wire.h"

#include <vector>

namespace angiopose::ui {

/// Path drawn from anchor to anchor; a live wire follows the vessels in between.
class LiveWirePath {
public:
    using Points = std::vector<Eigen::Vector2d>;

    bool isEmpty() const { return segments_.empty(); }
    void clear();

    /// Adds an anchor. The new segment is straight if `wire` is null or `straight` is set.
    void addAnchor(const Eigen::Vector2d& pointPx, core::LiveWire* liveWire, bool straight);
    void undoStep(core::LiveWire* liveWire);   ///< removes the last anchor
    void previewTo(const Eigen::Vector2d& pointPx, core::LiveWire* liveWire,
                   bool straight);   ///< previews the next anchor

    Points points() const;   ///< points of the path, without the preview
    Points anchors() const;
    const Points& preview() const { return preview_; }

private:
    Points segmentTo(const Eigen::Vector2d& pointPx, core::LiveWire* liveWire, bool straight) const;

    std::vector<Points>
        segments_;   ///< segments, each ending at an anchor; the first consists only of the first anchor
    Points preview_;
};

}   // namespace angiopose::ui
