#include "core/registration/wire/wire_alignment.h"

#include <algorithm>
#include <limits>

namespace angiopose::core {
namespace {

enum class WarpFrom : unsigned char { Nothing, Curve, Tree, Both };

struct WarpCell {
    double cost = std::numeric_limits<double>::infinity();
    double measurements = 0.0;   ///< of the move that led here
    WarpFrom from = WarpFrom::Nothing;
};

/// All alignments of the first knots with the first points.
class Warping {
public:
    Warping(const SeenKnots& seen, const WireCurve& curve, const WireModel& model)
        : seen_(seen), curve_(curve), model_(model), cells_(seen.size() * curve.size())
    {
        for (std::size_t j = 0; j < seen.size(); ++j) {
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
        for (std::size_t j = 0; j < seen_.size(); ++j) {
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

    double skipped(double lengthPx) const
    {
        return model_.skipCost * lengthPx * seen_.mmPerPx / model_.correlationMm;
    }

    void fill(std::size_t j, std::size_t k)
    {
        const double squaredMm2 = seen_.mmPerPx * seen_.mmPerPx * (seen_.pixels[j] - curve_.pointsPx[k]).squaredNorm();
        const Eigen::Vector2d step = j == 0 ? Eigen::Vector2d::Zero() : Eigen::Vector2d(seen_.pixels[j] - seen_.pixels[j - 1]);
        const double cost = model_.costOf(squaredMm2, model_.varianceMm2(seen_.radiusMm[j]), step, curve_.tangents[k]);
        const double perPx = seen_.mmPerPx / model_.correlationMm;
        const double alongTree = perPx * step.norm();
        const double alongCurve = k == 0 ? 0.0 : perPx * (curve_.alongPx[k] - curve_.alongPx[k - 1]);
        WarpCell best{skipped(curve_.alongPx[k]), 0.0, WarpFrom::Nothing};
        const auto offer = [&](const WarpCell& before, double measurements, WarpFrom from) {
            const double sum = before.cost + measurements * cost;
            best = sum < best.cost ? WarpCell{sum, measurements, from} : best;
        };
        if (k > 0) {
            offer(at(j, k - 1), alongCurve, WarpFrom::Curve);
        }
        if (j > 0) {
            offer(at(j - 1, k), alongTree, WarpFrom::Tree);
        }
        if (j > 0 && k > 0) {
            offer(at(j - 1, k - 1), std::max(alongTree, alongCurve), WarpFrom::Both);
        }
        cells_[j * curve_.size() + k] = best;
    }

    std::vector<WirePair> pairsUpTo(std::size_t j, std::size_t k) const
    {
        std::vector<WirePair> pairs;
        while (true) {
            const WarpCell& cell = at(j, k);
            pairs.push_back({j, k, cell.measurements});
            if (cell.from == WarpFrom::Nothing) {
                break;
            }
            j -= cell.from == WarpFrom::Curve ? 0 : 1;
            k -= cell.from == WarpFrom::Tree ? 0 : 1;
        }
        std::ranges::reverse(pairs);
        return pairs;
    }

    const SeenKnots& seen_;
    const WireCurve& curve_;
    const WireModel& model_;
    std::vector<WarpCell> cells_;
};

}   // namespace

double WireAlignment::followedPx(const WireCurve& curve) const
{
    return pairs.empty() ? 0.0 : curve.alongPx[pairs.back().point] - curve.alongPx[pairs.front().point];
}

WireAlignment alignWire(const SeenKnots& seen, const WireCurve& curve, const WireModel& model)
{
    return Warping(seen, curve, model).cheapest();
}

}   // namespace angiopose::core
