#pragma once

#include "core/registration/matching/feature_map.h"
#include "core/registration/problem/registration_problem.h"

namespace angiopose::core {

/// Target as short line segments, indexed by pixel position and built once per image (ALGORITHMS §6.2, §6.15).
class TargetLines {
public:
    struct Line {
        double x, y;   ///< point of the curve, px
        double tx, ty;   ///< unit tangent at that point
        bool hasPrevious, hasNext;   ///< whether the previous and the next line belong to the same curve
    };

    TargetLines(const TargetSamples& target, const ProjectionCamera& camera);

    /// Returns the line nearest to a pixel, found in the lookup table and refined along its curve.
    const Line& nearest(double u, double v) const
    {
        const Line* line = &lines_[map_.lookUp(u, v)];
        double best = squaredDistance(*line, u, v);
        while (line->hasNext && squaredDistance(line[1], u, v) < best) {
            ++line;
            best = squaredDistance(*line, u, v);
        }
        while (line->hasPrevious && squaredDistance(line[-1], u, v) < best) {
            --line;
            best = squaredDistance(*line, u, v);
        }
        return *line;
    }

    static double squaredDistance(const Line& line, double u, double v)
    {
        return (line.x - u) * (line.x - u) + (line.y - v) * (line.y - v);
    }

    const std::vector<Line>& lines() const { return lines_; }

private:
    FeatureMap map_;
    std::vector<Line> lines_;
};

}   // namespace angiopose::core
