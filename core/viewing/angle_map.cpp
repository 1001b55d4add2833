#include "core/viewing/angle_map.h"

#include "core/geometry/angle_units.h"
#include "core/geometry/c_arm.h"
#include "core/messages/messages.h"
#include "core/support/parallel_for.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace angiopose::core {
namespace {

constexpr double minStepDeg = 0.5;
constexpr double angleToleranceDeg = 0.1;
constexpr double minSeparationDeg = 20.0;
constexpr std::size_t maxSuggestions = 3;
constexpr double maxRefinedCostGap = 0.1;   // cost above the best grid point beyond which refinement is not worthwhile

std::optional<Message> findProblem(const AngleMapOptions& options)
{
    const auto isRange = [](const AngleRange& range, double limitDeg) {
        return range.fromDeg <= range.toDeg && std::abs(range.fromDeg) <= limitDeg && std::abs(range.toDeg) <= limitDeg;
    };
    if (!isRange(options.primary, 180.0)) {
        return messages::angleRangeInvalid("LAO/RAO", 180);
    }
    if (!isRange(options.secondary, 90.0)) {
        return messages::angleRangeInvalid("CRA/CAU", 90);
    }
    if (!(options.stepDeg >= minStepDeg)) {
        return messages::angleStepTooFine(Quantity{minStepDeg, 1, "°"});
    }
    return {};
}

/// Divides the range into equal steps of at most `stepDeg`, including both ends.
std::vector<double> angleGrid(const AngleRange& range, double stepDeg)
{
    const auto steps = static_cast<int>(std::ceil((range.toDeg - range.fromDeg) / stepDeg - 1e-9));
    std::vector<double> grid{range.fromDeg};
    for (int i = 1; i <= steps; ++i) {
        grid.push_back(range.fromDeg + (range.toDeg - range.fromDeg) * i / steps);
    }
    return grid;
}

/// Whether no neighboring grid point has a lower cost.
bool isLocalMinimum(const AngleMap& map, std::size_t column, std::size_t row)
{
    const double cost = map.at(column, row).cost();
    for (std::size_t y = row - std::min<std::size_t>(row, 1); y <= std::min(row + 1, map.secondaryDeg.size() - 1);
         ++y) {
        for (std::size_t x = column - std::min<std::size_t>(column, 1);
             x <= std::min(column + 1, map.primaryDeg.size() - 1); ++x) {
            if (map.at(x, y).cost() < cost) {
                return false;
            }
        }
    }
    return true;
}

class AngleSearch {
public:
    AngleSearch(const ViewEvaluator& evaluator, const PoseAtAngles& poseAt, const AngleMapOptions& options)
        : evaluator_(evaluator), poseAt_(poseAt), options_(options)
    {
    }

    AngleSuggestion at(const GantryAngles& angles) const { return {angles, evaluator_.from(poseAt_(angles))}; }

    /// Descends in eight directions, halving the step, within the gantry limits.
    AngleSuggestion refined(AngleSuggestion best) const
    {
        for (double step = 0.5 * options_.stepDeg; step > 0.5 * angleToleranceDeg;) {
            const AngleSuggestion next = bestAround(best, step);
            const bool isBetter = next.quality.cost() < best.quality.cost();
            best = isBetter ? next : best;
            step *= isBetter ? 1.0 : 0.5;
        }
        return best;
    }

private:
    AngleSuggestion bestAround(const AngleSuggestion& middle, double stepDeg) const
    {
        AngleSuggestion best = middle;
        for (int y = -1; y <= 1; ++y) {
            for (int x = -1; x <= 1; ++x) {
                const AngleSuggestion candidate =
                    at({within(options_.primary, middle.angles.primaryDeg + x * stepDeg),
                        within(options_.secondary, middle.angles.secondaryDeg + y * stepDeg)});
                best = candidate.quality.cost() < best.quality.cost() ? candidate : best;
            }
        }
        return best;
    }

    static double within(const AngleRange& range, double deg) { return std::clamp(deg, range.fromDeg, range.toDeg); }

    const ViewEvaluator& evaluator_;
    const PoseAtAngles& poseAt_;
    const AngleMapOptions& options_;
};

/// Returns the angle in degrees between the rays of two gantry positions.
double angleBetweenBeamsDeg(const GantryAngles& a, const GantryAngles& b)
{
    const double cosine =
        detectorDirection(a.primaryDeg, a.secondaryDeg).dot(detectorDirection(b.primaryDeg, b.secondaryDeg));
    return std::acos(std::clamp(cosine, -1.0, 1.0)) * degreesPerRadian;
}

std::vector<AngleSuggestion> suggestions(const AngleMap& map, const AngleSearch& search)
{
    std::vector<AngleSuggestion> minima;
    double minCost = std::numeric_limits<double>::infinity();
    for (const ViewQuality& quality : map.qualities) {
        minCost = std::min(minCost, quality.cost());
    }
    for (std::size_t row = 0; row < map.secondaryDeg.size(); ++row) {
        for (std::size_t column = 0; column < map.primaryDeg.size(); ++column) {
            if (map.at(column, row).cost() <= minCost + maxRefinedCostGap && isLocalMinimum(map, column, row)) {
                minima.push_back(
                    search.refined({{map.primaryDeg[column], map.secondaryDeg[row]}, map.at(column, row)}));
            }
        }
    }
    std::ranges::stable_sort(minima, {}, [](const AngleSuggestion& each) { return each.quality.cost(); });
    std::vector<AngleSuggestion> separated;
    for (const AngleSuggestion& minimum : minima) {
        const bool isNew = std::ranges::none_of(separated, [&](const AngleSuggestion& better) {
            return angleBetweenBeamsDeg(better.angles, minimum.angles) < minSeparationDeg;
        });
        if (isNew && separated.size() < maxSuggestions) {
            separated.push_back(minimum);
        }
    }
    return separated;
}

const Eigen::Vector3d anyIsocenter = Eigen::Vector3d::Zero();   // same before and after the rotation, so it cancels

}   // namespace

Result<AngleMap> computeAngleMap(const ViewEvaluator& evaluator, const PoseAtAngles& poseAt,
                                 const AngleMapOptions& options, const std::function<ObserverDecision(double)>& observe)
{
    if (const auto problem = findProblem(options)) {
        return Error(*problem);
    }
    const AngleSearch search(evaluator, poseAt, options);
    AngleMap map{angleGrid(options.primary, options.stepDeg), angleGrid(options.secondary, options.stepDeg), {}, {}};
    const std::size_t columns = map.primaryDeg.size();
    map.qualities.resize(columns * map.secondaryDeg.size());
    const auto evaluate = [&](std::size_t i) {
        map.qualities[i] = search.at({map.primaryDeg[i % columns], map.secondaryDeg[i / columns]}).quality;
    };
    const auto shouldContinue = [&](double done) { return !observe || observe(done) == ObserverDecision::Continue; };
    if (!parallelFor(map.qualities.size(), threadCount(options.threads), evaluate, shouldContinue)) {
        return Cancellation{messages::anglesStopped()};
    }
    map.best = suggestions(map, search);
    return map;
}

std::optional<GantryAngles> gantryAnglesOf(const View& view)
{
    const CArm cArm = cArmOfFrame(view);
    if (!cArm.primaryAngleDeg.value || !cArm.secondaryAngleDeg.value) {
        return {};
    }
    return GantryAngles{*cArm.primaryAngleDeg.value, *cArm.secondaryAngleDeg.value};
}

Result<PoseAtAngles> poseForGantryAngles(const View& view)
{
    const CArm now = cArmOfFrame(view);
    const auto gantry = cameraFromPatient(now, anyIsocenter);
    if (!gantry) {
        return gantry.error();
    }
    const RigidTransform gantryFromVessels = gantry.value().inverse() * view.cameraFromPatient;
    return PoseAtAngles([now, gantryFromVessels](const GantryAngles& angles) {
        CArm turned = now;
        turned.primaryAngleDeg.value = angles.primaryDeg;
        turned.secondaryAngleDeg.value = angles.secondaryDeg;
        return cameraFromPatient(turned, anyIsocenter).value() * gantryFromVessels;
    });
}

}   // namespace angiopose::core
