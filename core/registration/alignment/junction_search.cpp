#include "core/registration/alignment/junction_search.h"

#include "core/geometry/angle_units.h"
#include "core/registration/alignment/alignment_points.h"
#include "core/support/cell_index.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>
#include <numeric>
#include <tuple>

namespace angiopose::core {
namespace {

constexpr JunctionScale inTree{2.5, 12.0};   // mm
constexpr JunctionScale inImage{5.0, 20.0};   // px
constexpr double shortestBasePx = 50.0;
constexpr double maxZoom = 1.25;   // maximum scale ratio; corresponds to a depth error of 160 mm
constexpr int sectors = 64;
constexpr int spreadSectors = 6;   // tolerance on either side: directions within 34° match
constexpr int minMatchingDirections = 2;   // minimum number of matching directions, of the three at a bifurcation
constexpr double endOn = 0.3;   // directions nearly along the ray carry no information in the image
constexpr int junctionCellPx = 8;
constexpr double meetingPx = 12.0;
constexpr std::size_t maxBaseTrials = 60'000'000;   // compared bases plus looked-up nodes; takes well below a second
constexpr std::size_t maxJunctions = 200;   // maximum number of junctions used to form bases
constexpr std::size_t fitsPerTilt = 6;
constexpr std::size_t usedJunctionPoints = 90;
constexpr double closenessPx = 11.0;
constexpr double tiltStepDeg = 10.0;
constexpr double minRollDeg = 5.0;   // minimum roll range: junctions are traced a few px off, which adds apparent roll
constexpr Basin basin{10.0, 5.0 * radiansPerDegree};

/// Returns a stride near the golden section of the count, which spreads any initial part of the sequence evenly.
std::size_t strideCoprimeTo(std::size_t count)
{
    auto step = static_cast<std::size_t>(0.618 * static_cast<double>(count)) + 1;
    while (std::gcd(step, count) != 1 && count > 1) {
        ++step;
    }
    return step;
}

double sectorsOf(const Eigen::Vector2d& direction)
{
    return std::atan2(direction.y(), direction.x()) * sectors / (2.0 * std::numbers::pi);
}

/// Returns the rotation of the optical axis onto the ray through a point, which centers that point in the image.
Eigen::Matrix3d towards(const Eigen::Vector3d& inCamera)
{
    return Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), inCamera).toRotationMatrix();
}

Eigen::Vector2d rotated(const Eigen::Vector2d& point, const Eigen::Vector2d& turn)
{
    return {turn.x() * point.x() - turn.y() * point.y(), turn.y() * point.x() + turn.x() * point.y()};
}

/// Returns rotation vectors about the camera's x and y axes, evenly spread over the search range and including 0.
std::vector<Eigen::Vector3d> tiltsWithin(const SearchRange& range)
{
    const int half = static_cast<int>(range.tiltDeg / tiltStepDeg);
    const int halfX = range.freedom.isLocked(PoseAxis::CraCau) ? 0 : half;
    const int halfY = range.freedom.isLocked(PoseAxis::LaoRao) ? 0 : half;
    std::vector<Eigen::Vector3d> tilts;
    for (int x = -halfX; x <= halfX; ++x) {
        for (int y = -halfY; y <= halfY; ++y) {
            const Eigen::Vector3d tiltDeg(x * tiltStepDeg, y * tiltStepDeg, 0.0);
            if (tiltDeg.norm() <= range.tiltDeg) {
                tilts.emplace_back(tiltDeg * radiansPerDegree);
            }
        }
    }
    return tilts;
}

}   // namespace

JunctionSearch::DirectionBits JunctionSearch::directionBits(std::span<const Eigen::Vector2d> directions, int spread)
{
    DirectionBits ways = 0;
    for (const Eigen::Vector2d& direction : directions) {
        const auto sector = static_cast<int>(std::lround(sectorsOf(direction)));
        for (int offset = -spread; offset <= spread; ++offset) {
            ways |= std::rotl(DirectionBits{1}, sector + offset);
        }
    }
    return ways;
}

JunctionSearch::Base JunctionSearch::baseOf(const std::vector<ImageNode>& places, int from, int to)
{
    const Eigen::Vector2d base = places[static_cast<std::size_t>(to)].px - places[static_cast<std::size_t>(from)].px;
    const double lengthPx = base.norm();
    return {lengthPx, base / lengthPx, sectorsOf(base), from, to};
}

JunctionSearch::JunctionSearch(const RegistrationProblem& problem, const TargetLines& target)
    : camera_(problem.camera),
      target_(target),
      nodes_(findJunctions<3>(problem.tree.points, problem.tree.branchIndex, inTree)),
      columns_(problem.camera.width / junctionCellPx + 1),
      rows_(problem.camera.height / junctionCellPx + 1),
      points_(alignmentPoints(problem.tree, strideFor(problem.tree.size(), usedJunctionPoints)))
{
    for (Junction<3>& node : nodes_) {
        node.point -= problem.tree.centroid;
    }
    const Eigen::Vector2d axes(camera_.fx < 0.0 ? -1.0 : 1.0, 1.0);
    const auto found = findJunctions<2>(problem.target.points, problem.target.curveIndex, inImage);
    for (const Junction<2>& junction : found) {
        std::vector<Eigen::Vector2d> ways;
        for (const Eigen::Vector2d& way : junction.directions) {
            ways.emplace_back(way.cwiseProduct(axes));
        }
        const Eigen::Vector2d px = (junction.point - Eigen::Vector2d(camera_.cx, camera_.cy)).cwiseProduct(axes);
        junctions_.push_back({px, directionBits(ways, spreadSectors)});
    }
    markJunctions(found);
    collectBases();
}

void JunctionSearch::markJunctions(std::span<const Junction<2>> found)
{
    isNearJunction_.resize(cellIndex(rows_, columns_, 0));
    for (int row = 0; row < rows_; ++row) {
        for (int column = 0; column < columns_; ++column) {
            const Eigen::Vector2d middle((column + 0.5) * junctionCellPx, (row + 0.5) * junctionCellPx);
            isNearJunction_[cellIndex(row, columns_, column)] =
                std::any_of(found.begin(), found.end(), [&](const Junction<2>& junction) {
                    return (junction.point - middle).squaredNorm() < meetingPx * meetingPx;
                });
        }
    }
}

void JunctionSearch::collectBases()
{
    const auto stride = static_cast<int>(strideFor(junctions_.size(), maxJunctions));
    for (int from = 0; from < static_cast<int>(junctions_.size()); from += stride) {
        for (int to = 0; to < static_cast<int>(junctions_.size()); to += stride) {
            if (from != to) {
                bases_.push_back(baseOf(junctions_, from, to));
            }
        }
    }
    std::sort(bases_.begin(), bases_.end(), [](const Base& a, const Base& b) {
        return std::tie(a.lengthPx, a.from, a.to) < std::tie(b.lengthPx, b.from, b.to);
    });
}

std::vector<JunctionSearch::ImageNode> JunctionSearch::projectNodes(const Eigen::Matrix3d& rotation,
                                                                    double depthMm) const
{
    std::vector<ImageNode> seen;
    std::vector<Eigen::Vector2d> ways;
    for (const Junction<3>& node : nodes_) {
        const Eigen::Vector3d rotated = rotation * node.point;
        ways.clear();
        for (const Eigen::Vector3d& way : node.directions) {
            const Eigen::Vector2d across = (rotation * way).head<2>();
            if (across.norm() > endOn) {
                ways.push_back(across);
            }
        }
        seen.push_back({camera_.fy / (depthMm + rotated.z()) * rotated.head<2>(), directionBits(ways, 0)});
    }
    return seen;
}

int JunctionSearch::matchedNodeCount(const std::vector<ImageNode>& nodes, const Fit& fit) const
{
    const double axis = camera_.fx < 0.0 ? -1.0 : 1.0;
    int count = 0;
    for (const ImageNode& node : nodes) {
        const Eigen::Vector2d place = fit.zoom * rotated(node.px, fit.turn) + fit.centroidPx;
        const double u = (axis * place.x() + camera_.cx) / junctionCellPx;
        const double v = (place.y() + camera_.cy) / junctionCellPx;
        if (u >= 0.0 && v >= 0.0 && u < columns_ && v < rows_) {
            count += isNearJunction_[cellIndex(static_cast<int>(v), columns_, static_cast<int>(u))];
        }
    }
    return count;
}

/// Aligns the base between two nodes with every base of similar length between junctions; returns the cost spent.
std::size_t JunctionSearch::tryBase(const Base& base, const std::vector<ImageNode>& nodes, double maxRoll,
                                    std::vector<Fit>& fits) const
{
    const ImageNode& a = nodes[static_cast<std::size_t>(base.from)];
    const ImageNode& b = nodes[static_cast<std::size_t>(base.to)];
    const double minCosine = std::cos(maxRoll);
    auto other = std::lower_bound(bases_.begin(), bases_.end(), base.lengthPx / maxZoom,
                                  [](const Base& one, double length) { return one.lengthPx < length; });
    std::size_t cost = 0;
    for (; other != bases_.end() && other->lengthPx <= base.lengthPx * maxZoom; ++other) {
        ++cost;
        const auto roll = static_cast<int>(std::lrint(other->sectors - base.sectors));
        const ImageNode& i = junctions_[static_cast<std::size_t>(other->from)];
        const ImageNode& j = junctions_[static_cast<std::size_t>(other->to)];
        if (std::popcount(std::rotl(a.ways, roll) & i.ways) < minMatchingDirections ||
            std::popcount(std::rotl(b.ways, roll) & j.ways) < minMatchingDirections) {
            continue;
        }
        Fit fit;
        fit.zoom = other->lengthPx / base.lengthPx;
        fit.turn = rotated(other->along, {base.along.x(), -base.along.y()});
        if (fit.turn.x() < minCosine) {
            continue;
        }
        fit.centroidPx = 0.5 * (i.px + j.px - fit.zoom * rotated(a.px + b.px, fit.turn));
        fit.matchedNodeCount = matchedNodeCount(nodes, fit);
        cost += nodes.size();
        if (fits.size() == fitsPerTilt && fit.matchedNodeCount <= fits.back().matchedNodeCount) {
            continue;
        }
        const auto place = std::upper_bound(fits.begin(), fits.end(), fit, [](const Fit& x, const Fit& y) {
            return x.matchedNodeCount > y.matchedNodeCount;
        });
        fits.insert(place, fit);
        fits.resize(std::min(fits.size(), fitsPerTilt));
    }
    return cost;
}

/// Tries every base once, striding through the list, until the budget is spent.
std::vector<JunctionSearch::Fit> JunctionSearch::findFits(const std::vector<ImageNode>& nodes, double maxRoll,
                                                          std::size_t budget) const
{
    std::vector<Fit> fits;
    const std::size_t count = nodes.size();
    const std::size_t pairs = count * (count - std::min<std::size_t>(1, count));
    const std::size_t step = strideCoprimeTo(pairs);
    std::size_t spent = 0;
    for (std::size_t k = 0, pair = 0; k < pairs && spent < budget; ++k, pair = (pair + step) % pairs) {
        const std::size_t from = pair / (count - 1);
        const std::size_t to = from + 1 + pair % (count - 1);
        if (to < count) {   // skips duplicates, so that each pair is tried once
            const Base base = baseOf(nodes, static_cast<int>(from), static_cast<int>(to));
            spent += base.lengthPx >= shortestBasePx ? tryBase(base, nodes, maxRoll, fits) : 1;
        }
    }
    return fits;
}

double JunctionSearch::closeness(const CentroidPose& pose) const
{
    double sum = 0.0;
    for (const AlignmentPoint& point : points_) {
        const auto pixel = project(camera_, pose.rotation * point.fromCentroid + pose.centroidInCamera);
        if (pixel && pixel->cwiseAbs().maxCoeff() < 1e6) {
            const double squared =
                TargetLines::squaredDistance(target_.nearest(pixel->x(), pixel->y()), pixel->x(), pixel->y());
            sum += std::exp(-0.5 * squared / (closenessPx * closenessPx));
        }
    }
    return sum / static_cast<double>(points_.size());
}

/// Converts the fit of a tree viewed with rotation `view` to a pose.
CentroidPose JunctionSearch::poseOf(const Fit& fit, const Eigen::Matrix3d& view, double depthMm) const
{
    CentroidPose pose;
    const double zMm = depthMm / fit.zoom;
    pose.centroidInCamera << fit.centroidPx / camera_.fy * zMm, zMm;
    const double roll = std::atan2(fit.turn.y(), fit.turn.x());
    pose.rotation = towards(pose.centroidInCamera) * expSo3({0.0, 0.0, roll}) * view;
    return pose;
}

std::vector<CoarseCandidate> JunctionSearch::find(const CentroidPose& start, const SearchRange& range,
                                                  const std::function<ObserverDecision(double)>& observe) const
{
    std::vector<CoarseCandidate> found;
    const double depthMm = std::max(minProjectableDepthMm, start.centroidInCamera.z());
    const Eigen::Matrix3d startView = towards(start.centroidInCamera).transpose() * start.rotation;
    const double rollDeg = range.freedom.isLocked(PoseAxis::Roll) ? 0.0 : range.rollDeg;
    const double maxRoll = std::max(rollDeg, minRollDeg) * radiansPerDegree;
    const std::vector<Eigen::Vector3d> tilts = tiltsWithin(range);
    for (std::size_t k = 0; k < tilts.size(); ++k) {
        const Eigen::Matrix3d view = expSo3(tilts[k]) * startView;
        for (const Fit& fit : findFits(projectNodes(view, depthMm), maxRoll, maxBaseTrials / tilts.size())) {
            const CentroidPose pose = range.freedom.restoreLockedAxes(poseOf(fit, view, depthMm));
            const Eigen::Vector3d shift = pose.centroidInCamera - start.centroidInCamera;
            if (shift.head<2>().norm() <= range.radiusMm) {
                found.push_back({pose, closeness(pose)});
            }
        }
        if (observe(static_cast<double>(k + 1) / static_cast<double>(tilts.size())) == ObserverDecision::Stop) {
            break;
        }
    }
    return distinctCandidates(std::move(found), basin);
}

}   // namespace angiopose::core
