#include "core/registration/wire/follow_wire.h"

#include "core/registration/wire/wire_fit.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace angiopose::core {
namespace {

constexpr double knotSpacingMm = 2.0;
constexpr double wireSpacingMm = 2.0;
constexpr std::size_t mostWirePoints = 120;
constexpr std::size_t mostKnots = 4000;
constexpr std::size_t mostWays = 40;   // tried in each of two rounds
constexpr double firstReachMm = 2.5;   // of ways looked for about each shift of the start
constexpr double secondReachMm = 1.5;
constexpr double shiftStepMm = 4.0;   // between shifts
constexpr double shiftSigmas = 2.0;   // how far they go
constexpr int mostShiftsPerSide = 4;
constexpr double leastFollowedMm = 3.0;   // of a branch, to be told among those that the wire takes
constexpr double leastFollowedShare = 0.2;   // of the wire, for a way to count
constexpr double leastProbability = 0.01;
constexpr std::size_t mostPaths = 9;
constexpr double sameCourse = 0.85;   // of two ways, to be told as one
constexpr double temperature =
    0.8;   // of probabilities: what turns evidence into hit rates (wire_table --world made-up)

/// The samples as branches again.
VesselTree treeOf(const TreeSamples& samples)
{
    VesselTree tree;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        if (i == 0 || samples.branchIndex[i] != samples.branchIndex[i - 1]) {
            tree.branches.push_back({samples.branchIds[static_cast<std::size_t>(samples.branchIndex[i])], {}, {}, {}});
        }
        tree.branches.back().pointsInPatient.push_back(samples.points[i]);
        tree.branches.back().radiusMm.push_back(samples.radiusMm[i]);
    }
    return tree;
}

TreeKnots knotsOf(const VesselTree& tree)
{
    double lengthMm = 0.0;
    for (const VesselBranch& branch : tree.branches) {
        lengthMm += branch.lengthMm();
    }
    return treeKnots(tree, {}, std::max(knotSpacingMm, lengthMm / static_cast<double>(mostKnots)));
}

struct PosedWay {
    TreeWay way;
    CentroidPose seenFrom;
    double cost = 0.0;   ///< of way and pose
};

/// What stands for the ways that the image does not tell apart.
struct ToldWay {
    WirePath path;   ///< of the most likely
    const WireFit* fit = nullptr;   ///< of the same
    std::vector<std::size_t> course;   ///< knots beside the wire, sorted
    std::vector<double> logEvidences;   ///< of them all
};

/// Of the longer course, that the other takes too.
double sharedPart(const std::vector<std::size_t>& a, const std::vector<std::size_t>& b)
{
    std::vector<std::size_t> shared;
    std::ranges::set_intersection(a, b, std::back_inserter(shared));
    return static_cast<double>(shared.size()) / static_cast<double>(std::max(a.size(), b.size()));
}

/// One search under way: ways → fits → paths.
class WireSearch {
public:
    WireSearch(const RegistrationProblem& problem, const RegistrationOptions& options, const WireObserver& observe)
        : problem_(problem),
          observe_(observe),
          tree_(treeOf(problem.tree)),
          knots_(knotsOf(tree_)),
          start_(aboutCentroid(problem.start, problem.tree.centroid)),
          prior_(startPrior(start_, options, problem.freedom)),
          curve_(wireCurve(problem.target, wireSpacingMm / mmPerPx(), mostWirePoints)),
          turned_(reversed(curve_)),
          wire_{problem.camera, knots_, problem.tree.centroid, problem.tree.spreadMm, curve_, turned_, prior_},
          wanted_(static_cast<std::size_t>(options.wire.way))
    {
        model_.offAxisMm = options.wire.offAxisMm;
        all_.resize(knots_.size());
        for (std::size_t k = 0; k < all_.size(); ++k) {
            all_[k] = k;
        }
    }

    WireFinding find()
    {
        tryWays(waysAbout(shiftedStarts(), firstReachMm), 0.5);
        if (!isStopped_ && !fits_.empty()) {
            tryWays(waysAbout({fits_.front().pose}, secondReachMm), 0.9);
        }
        if (!isStopped_) {
            report(1.0);
        }
        return finding();
    }

private:
    double mmPerPx() const
    {
        return millimetresPerPixel(problem_.camera, std::max(minProjectableDepthMm, start_.centroidInCamera.z()));
    }

    bool report(double progress)
    {
        const CentroidPose& best = fits_.empty() ? start_ : fits_.front().pose;
        isStopped_ = observe_(progress, cameraFromPatient(best, problem_.tree.centroid)) == Verdict::Stop;
        return !isStopped_;
    }

    /// The start, shifted across the ray as far as it may be off.
    std::vector<CentroidPose> shiftedStarts() const
    {
        std::vector<CentroidPose> starts;
        const double reachMm = shiftSigmas * prior_.std().segment<2>(3).maxCoeff();
        const double stepMm = std::max(shiftStepMm, reachMm / mostShiftsPerSide);
        const int perSide = static_cast<int>(reachMm / stepMm);
        for (int row = -perSide; row <= perSide; ++row) {
            for (int column = -perSide; column <= perSide; ++column) {
                Vector6d step = Vector6d::Zero();
                step[3] = column * stepMm;
                step[4] = row * stepMm;
                if (step.norm() <= reachMm) {
                    starts.push_back(prior_.freedom.held(moved(start_, step)));
                }
            }
        }
        return starts;
    }

    /// The most likely ways seen from any of the poses, each with the pose that it was seen from.
    std::vector<PosedWay> waysAbout(const std::vector<CentroidPose>& poses, double reachMm)
    {
        WireModel reaching = model_;
        reaching.reachMm = reachMm;
        std::vector<PosedWay> all;
        for (const CentroidPose& pose : poses) {
            const auto ways = likelyWays(knots_, wire_.seen(all_, pose), curve_, reaching, mostWays,
                                         [&] { return report(shareDone_); });
            for (const TreeWay& way : ways) {
                const double cost = way.cost + 0.5 * prior_.cost(pose);
                const auto known =
                    std::ranges::find(all, way.knots, [](const PosedWay& other) { return other.way.knots; });
                if (known == all.end()) {
                    all.push_back({way, pose, cost});
                } else if (cost < known->cost) {
                    *known = {way, pose, cost};
                }
            }
            if (isStopped_) {
                break;
            }
            shareDone_ += 0.4 / static_cast<double>(poses.size());
        }
        std::ranges::stable_sort(all, {}, &PosedWay::cost);
        all.resize(std::min(all.size(), mostWays));
        return all;
    }

    void tryWays(const std::vector<PosedWay>& ways, double shareInTheEnd)
    {
        const double from = shareDone_;
        for (std::size_t w = 0; w < ways.size() && !isStopped_; ++w) {
            fits_.push_back(fitWire(wire_, ways[w].way, ways[w].seenFrom, model_));
            std::ranges::stable_sort(fits_, std::ranges::greater(), &WireFit::logEvidence);
            shareDone_ = from + (shareInTheEnd - from) * static_cast<double>(w + 1) / static_cast<double>(ways.size());
            report(shareDone_);
        }
    }

    /// Branches in the order that the wire takes them; those that it hardly enters are left out.
    std::vector<int> branchesOf(const WireFit& fit) const
    {
        std::vector<int> ids;
        std::size_t first = fit.alignment.pairs.front().knot;
        for (std::size_t j = first; j <= fit.alignment.pairs.back().knot; ++j) {
            const bool isLast = j == fit.alignment.pairs.back().knot;
            const std::size_t branch = knots_.branchOf(fit.way.knots[j]);
            if (isLast || knots_.branchOf(fit.way.knots[j + 1]) != branch) {
                if (static_cast<double>(j - first) * knotSpacingMm >= leastFollowedMm || (isLast && ids.empty())) {
                    ids.push_back(tree_.branches[branch].id);
                }
                first = j + 1;
            }
        }
        return ids;
    }

    WirePath pathOf(const WireFit& fit) const
    {
        WirePath path;
        path.branchIds = branchesOf(fit);
        const std::size_t first = fit.way.knots[fit.alignment.pairs.front().knot];
        const std::size_t last = fit.way.knots[fit.alignment.pairs.back().knot];
        // Wires go from wide vessels into narrow ones.
        const bool isBackwards = knots_.radiusMm[last] > knots_.radiusMm[first];
        path.tipInPatient = knots_.places[isBackwards ? first : last];
        for (std::size_t j = fit.alignment.pairs.front().knot; j <= fit.alignment.pairs.back().knot; ++j) {
            path.courseInPatient.push_back(knots_.places[fit.way.knots[j]]);
        }
        if (isBackwards) {
            std::ranges::reverse(path.branchIds);
            std::ranges::reverse(path.courseInPatient);
        }
        path.cameraFromPatient = cameraFromPatient(fit.pose, problem_.tree.centroid);
        path.followedShare = fit.alignment.followedPx(curve_) / std::max(1e-9, curve_.lengthPx());
        const SeenKnots seen = wire_.seen(fit.way.knots, fit.pose);
        double squares = 0.0;
        double count = 0.0;
        for (const WirePair& pair : fit.alignment.pairs) {
            const Eigen::Vector2d offPx = seen.pixels[pair.knot] - wire_.curveOf(fit.way).pointsPx[pair.point];
            squares += pair.lengthMm * offPx.squaredNorm() * seen.mmPerPx * seen.mmPerPx;
            count += pair.lengthMm;
        }
        path.offAxisMm = count > 0.0 ? std::sqrt(squares / count) : 0.0;
        return path;
    }

    /// Ways told once: the same branches by the most likely of their fits, and ways of nearly the same visible course,
    /// which the image does not tell apart, by the most likely of them.
    std::vector<ToldWay> toldWays() const
    {
        std::vector<ToldWay> told;
        std::vector<std::vector<int>> known;
        for (const WireFit& fit : fits_) {
            if (fit.alignment.followedPx(curve_) < leastFollowedShare * curve_.lengthPx()) {
                continue;
            }
            WirePath path = pathOf(fit);
            std::vector<int> branches = path.branchIds;
            std::ranges::sort(branches);
            if (std::ranges::count(known, branches) > 0) {
                continue;
            }
            known.push_back(std::move(branches));
            std::vector<std::size_t> course = courseOf(fit);
            const auto same = std::ranges::find_if(
                told, [&](const ToldWay& other) { return sharedPart(other.course, course) >= sameCourse; });
            if (same != told.end()) {
                same->logEvidences.push_back(fit.logEvidence);
            } else {
                told.push_back({std::move(path), &fit, std::move(course), {fit.logEvidence}});
            }
        }
        return told;
    }

    WireFinding finding() const
    {
        WireFinding finding;
        finding.gapShare = curve_.gapShare;
        finding.stdBefore = prior_.std();
        std::vector<ToldWay> told = toldWays();
        if (!told.empty()) {
            shareOut(told);
            std::erase_if(told, [&](const ToldWay& way) {
                return way.path.probability < leastProbability && &way != &told.front();
            });
            told.resize(std::min(told.size(), mostPaths));
            finding.isAskedFor = wanted_ <= told.size();
            if (finding.isAskedFor) {
                const auto wanted = told.begin() + static_cast<std::ptrdiff_t>(wanted_) - 1;
                std::rotate(told.begin(), wanted, wanted + 1);
            }
            finding.covariance = spreadOf(told);
            finding.isFollowed = followedBy(*told.front().fit);
            for (ToldWay& way : told) {
                finding.paths.push_back(std::move(way.path));
            }
        }
        return finding;
    }

    /// Knots beside the wire, sorted.
    std::vector<std::size_t> courseOf(const WireFit& fit) const
    {
        const auto knot = [&](std::size_t place) { return fit.way.knots.begin() + static_cast<std::ptrdiff_t>(place); };
        std::vector<std::size_t> course(knot(fit.alignment.pairs.front().knot),
                                        knot(fit.alignment.pairs.back().knot + 1));
        std::ranges::sort(course);
        return course;
    }

    std::vector<std::uint8_t> followedBy(const WireFit& fit) const
    {
        std::vector<std::uint8_t> isFollowed(problem_.tree.size(), 0);
        for (std::size_t i = 0; i < isFollowed.size(); ++i) {
            for (std::size_t j = fit.alignment.pairs.front().knot; j <= fit.alignment.pairs.back().knot; ++j) {
                const double offMm = (knots_.places[fit.way.knots[j]] - problem_.tree.points[i]).norm();
                isFollowed[i] = offMm < knotSpacingMm ? 1 : isFollowed[i];
            }
        }
        return isFollowed;
    }

    /// By evidence; a wire that takes none of them is one more possibility. The most likely comes first.
    void shareOut(std::vector<ToldWay>& told) const
    {
        const double best = told.front().fit->logEvidence;
        const auto weight = [&](double logEvidence) { return std::exp((logEvidence - best) / temperature); };
        double sum = weight(-model_.skipPerMm * curve_.lengthPx() * mmPerPx());
        for (ToldWay& way : told) {
            for (const double logEvidence : way.logEvidences) {
                way.path.probability += weight(logEvidence);
            }
            sum += way.path.probability;
        }
        for (ToldWay& way : told) {
            way.path.probability /= sum;
        }
        std::ranges::stable_sort(told, std::ranges::greater(), [](const ToldWay& way) { return way.path.probability; });
    }

    /// Covariance of the first pose about the whole tree's centroid: within every path, and between them.
    Matrix6d spreadOf(const std::vector<ToldWay>& told) const
    {
        const CentroidPose& best = told.front().fit->pose;
        Matrix6d covariance = Matrix6d::Zero();
        double sum = 0.0;
        for (const ToldWay& way : told) {
            const Vector6d step = stepBetween(best, way.fit->pose);
            covariance += way.path.probability * (way.fit->covariance + step * step.transpose());
            sum += way.path.probability;
        }
        Matrix6d carry = Matrix6d::Identity();
        carry.bottomLeftCorner<3, 3>() = -skew(best.rotation * (problem_.wholeTreeCentroid - problem_.tree.centroid));
        return carry * (covariance / sum) * carry.transpose();
    }

    const RegistrationProblem& problem_;
    const WireObserver& observe_;
    VesselTree tree_;
    TreeKnots knots_;
    CentroidPose start_;
    StartPrior prior_;
    WireCurve curve_;
    WireCurve turned_;
    WireProblem wire_;
    WireModel model_;
    std::size_t wanted_;   ///< way, 1 the most likely
    std::vector<std::size_t> all_;   ///< numbers of the knots
    std::vector<WireFit> fits_;   ///< most likely first
    double shareDone_ = 0.0;
    bool isStopped_ = false;
};

}   // namespace

WireFinding followWire(const RegistrationProblem& problem, const RegistrationOptions& options,
                       const WireObserver& observe)
{
    return WireSearch(problem, options, observe).find();
}

}   // namespace angiopose::core
