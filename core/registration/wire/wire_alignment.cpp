#include "core/registration/wire/wire_alignment.h"

#include <algorithm>
#include <limits>

namespace angiopose::core {
namespace {

struct WarpCell {
    double cost = std::numeric_limits<double>::infinity();
    double lengthMm = 0.0;   ///< length of the move that ends here
    WireMove move;   ///< move that ends here; empty if the alignment starts here
};

/// Dynamic programming table with all alignments of the first knots and the first curve points.
class Warping {
public:
    Warping(const ProjectedKnots& projected, const WireCurve& curve, const WireModel& model)
        : projected_(projected), curve_(curve), model_(model), cells_(projected.size() * curve.size())
    {
        for (std::size_t j = 0; j < projected.size(); ++j) {
            for (std::size_t k = 0; k < curve.size(); ++k) {
                fill(j, k);
            }
        }
    }

    WireAlignment cheapest() const
    {
        WireAlignment alignment;
        alignment.cost = skipped(curve_.lengthPx());
        std::size_t lastKnot = 0;
        std::size_t lastPoint = 0;
        bool isAny = false;
        for (std::size_t j = 0; j < projected_.size(); ++j) {
            for (std::size_t k = 0; k < curve_.size(); ++k) {
                const double cost = at(j, k).cost + skipped(curve_.lengthPx() - curve_.alongPx[k]);
                if (cost < alignment.cost) {
                    alignment.cost = cost;
                    lastKnot = j;
                    lastPoint = k;
                    isAny = true;
                }
            }
        }
        if (isAny) {
            alignment.pairs = pairsUpTo(lastKnot, lastPoint);
        }
        return alignment;
    }

private:
    const WarpCell& at(std::size_t j, std::size_t k) const { return cells_[j * curve_.size() + k]; }

    double skipped(double lengthPx) const { return model_.skipPerMm * lengthPx * projected_.mmPerPx; }

    void fill(std::size_t j, std::size_t k)
    {
        const double squaredMm2 =
            projected_.mmPerPx * projected_.mmPerPx * (projected_.pixels[j] - curve_.pointsPx[k]).squaredNorm();
        const double variance = model_.varianceMm2(projected_.radiusMm[j]);
        if (!model_.isNearAxis(squaredMm2, variance)) {
            return;
        }
        const double perMm = model_.positionCostPerMm(squaredMm2, variance);
        WarpCell best{skipped(curve_.alongPx[k]), 0.0, {}};
        for (const WireMove& move : wireMoves) {
            if (j < move.knots || k < move.points) {
                continue;
            }
            const StepCost step = stepCost(model_, projected_.pixels[j] - projected_.pixels[j - move.knots], curve_, k,
                                           move.points, projected_.mmPerPx);
            const double sum = at(j - move.knots, k - move.points).cost + step.cost + perMm * step.lengthMm;
            best = sum < best.cost ? WarpCell{sum, step.lengthMm, move} : best;
        }
        cells_[j * curve_.size() + k] = best;
    }

    std::vector<WirePair> pairsUpTo(std::size_t j, std::size_t k) const
    {
        std::vector<WirePair> pairs;
        while (true) {
            const WarpCell& cell = at(j, k);
            pairs.push_back({j, k, cell.move, cell.lengthMm});
            if (cell.move.knots + cell.move.points == 0) {
                break;
            }
            j -= cell.move.knots;
            k -= cell.move.points;
        }
        std::ranges::reverse(pairs);
        return pairs;
    }

    const ProjectedKnots& projected_;
    const WireCurve& curve_;
    const WireModel& model_;
    std::vector<WarpCell> cells_;
};

}   // namespace

double WireAlignment::followedPx(const WireCurve& curve) const
{
    return pairs.empty() ? 0.0 : curve.alongPx[pairs.back().point] - curve.alongPx[pairs.front().point];
}

WireAlignment alignWire(const ProjectedKnots& projected, const WireCurve& curve, const WireModel& model)
{
    return Warping(projected, curve, model).cheapest();
}

}   // namespace angiopose::core
