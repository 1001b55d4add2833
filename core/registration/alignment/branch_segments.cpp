#include "core/registration/alignment/branch_segments.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <tuple>

namespace angiopose::core {
namespace {

constexpr std::size_t minSegmentPoints = 3;   // a cut closer to the end of the branch is moved to the end

/// Spatial hash of points into cubes as wide as the search radius.
class PointHash {
public:
    PointHash(const std::vector<Eigen::Vector3d>& points, double reach) : points_(points), reach_(reach)
    {
        for (std::size_t i = 0; i < points.size(); ++i) {
            members_[cubeOf(points[i])].push_back(i);
        }
    }

    /// Calls `visit(number)` for every point within the search radius.
    template <class Visit>
    void visitNear(const Eigen::Vector3d& place, const Visit& visit) const
    {
        const auto [x, y, z] = cubeOf(place);
        for (int dx = -1; dx <= 1; ++dx) {
            for (int dy = -1; dy <= 1; ++dy) {
                for (int dz = -1; dz <= 1; ++dz) {
                    const auto cube = members_.find({x + dx, y + dy, z + dz});
                    for (std::size_t k = 0; cube != members_.end() && k < cube->second.size(); ++k) {
                        if ((points_[cube->second[k]] - place).norm() <= reach_) {
                            visit(cube->second[k]);
                        }
                    }
                }
            }
        }
    }

private:
    using Cube = std::tuple<int, int, int>;

    Cube cubeOf(const Eigen::Vector3d& point) const
    {
        const Eigen::Vector3i cube = (point / reach_).array().floor().cast<int>();
        return {cube.x(), cube.y(), cube.z()};
    }

    const std::vector<Eigen::Vector3d>& points_;
    double reach_;
    std::map<Cube, std::vector<std::size_t>> members_;
};

struct Span {
    std::size_t from, to;   ///< point range of one branch, [from, to)
};

/// Branches of a tree or traced curves of an image.
struct Curves {
    const std::vector<Eigen::Vector3d>& points;
    const std::vector<int>& index;   ///< curve index of each point
    double maxGap;
};

/// Point at which a branch is cut by a junction.
struct Cut {
    std::size_t at;   ///< index of the tree point
    int junction;
};

std::vector<Span> spansOf(const Curves& curves)
{
    std::vector<Span> spans;
    for (std::size_t i = 0; i < curves.points.size(); ++i) {
        if (i == 0 || curves.index[i] != curves.index[i - 1]) {
            spans.push_back({i, i});
        }
        spans.back().to = i + 1;
    }
    return spans;
}

/// Returns, for each branch that passes near a position, its nearest point.
std::vector<std::size_t> passingPoints(const Curves& curves, const PointHash& cubes, const Eigen::Vector3d& place)
{
    std::map<int, std::pair<double, std::size_t>> nearest;
    cubes.visitNear(place, [&](std::size_t i) {
        const std::pair candidate((curves.points[i] - place).squaredNorm(), i);
        const auto [known, isNew] = nearest.try_emplace(curves.index[i], candidate);
        known->second = isNew ? candidate : std::min(known->second, candidate);
    });
    std::vector<std::size_t> points;
    for (const auto& [branch, found] : nearest) {
        points.push_back(found.second);
    }
    return points;
}

class CurveSplitter {
public:
    explicit CurveSplitter(const Curves& curves) : curves_(curves), spans_(spansOf(curves)) {}

    BranchSegments pieces()
    {
        findJunctions();
        for (const Span& span : spans_) {
            part(span);
        }
        result_.junctionCount = static_cast<int>(junctionPositions_.size());
        dropRings();
        return std::move(result_);
    }

private:
    void findJunctions()
    {
        const PointHash cubes(curves_.points, curves_.maxGap);
        for (const Span& span : spans_) {
            for (const std::size_t end : {span.from, span.to - 1}) {
                const Eigen::Vector3d& place = curves_.points[end];
                const bool isKnown = std::ranges::any_of(junctionPositions_, [&](const Eigen::Vector3d& known) {
                    return (known - place).norm() <= curves_.maxGap;
                });
                const auto passing = isKnown ? std::vector<std::size_t>() : passingPoints(curves_, cubes, place);
                if (passing.size() > 1) {
                    for (const std::size_t point : passing) {
                        cuts_.push_back({point, static_cast<int>(junctionPositions_.size())});
                    }
                    junctionPositions_.push_back(place);
                }
            }
        }
        std::ranges::sort(cuts_, {}, [](const Cut& cut) { return std::pair(cut.at, cut.junction); });
    }

    void part(const Span& span)
    {
        const auto add = [&](std::size_t from, std::size_t to) {
            result_.pieces.push_back({curves_.index[span.from], from, to});
        };
        const auto join = [&](int junction) {
            result_.incidences.push_back({static_cast<int>(result_.pieces.size()) - 1, junction});
        };
        const auto first = std::ranges::lower_bound(cuts_, span.from, {}, &Cut::at);
        std::size_t begun = span.from;
        std::vector<int> atBegin;
        for (auto cut = first; cut != cuts_.end() && cut->at < span.to; ++cut) {
            const bool isAtBegin = cut->at < begun + minSegmentPoints;
            const bool isAtEnd = cut->at + minSegmentPoints >= span.to;
            if (!isAtBegin && !isAtEnd) {
                add(begun, cut->at);
                std::ranges::for_each(atBegin, join);
                join(cut->junction);
                atBegin.clear();
                begun = cut->at;
            }
            atBegin.push_back(cut->junction);
        }
        add(begun, span.to);
        std::ranges::for_each(atBegin, join);
    }

    int rootOf(int node)
    {
        while (leader_[static_cast<std::size_t>(node)] != node) {
            node = leader_[static_cast<std::size_t>(node)] =
                leader_[static_cast<std::size_t>(leader_[static_cast<std::size_t>(node)])];
        }
        return node;
    }

    void dropRings()
    {
        const auto pieceCount = static_cast<int>(result_.pieces.size());
        leader_.resize(static_cast<std::size_t>(pieceCount + result_.junctionCount));
        std::iota(leader_.begin(), leader_.end(), 0);
        std::erase_if(result_.incidences, [&](const SegmentIncidence& joint) {
            const int a = rootOf(joint.piece);
            const int b = rootOf(pieceCount + joint.junction);
            leader_[static_cast<std::size_t>(a)] = b;
            return a == b;
        });
    }

    Curves curves_;
    std::vector<Span> spans_;
    std::vector<Eigen::Vector3d> junctionPositions_;   ///< positions of the junctions
    std::vector<Cut> cuts_;   ///< in ascending order of the tree points
    std::vector<int> leader_;
    BranchSegments result_;
};

}   // namespace

BranchSegments splitAtBifurcations(const TreeSamples& tree)
{
    return splitAtBifurcations(tree.points, tree.branchIndex, maxBranchGapMm);
}

BranchSegments splitAtBifurcations(const std::vector<Eigen::Vector3d>& points, const std::vector<int>& curveIndex,
                                   double maxGap)
{
    return CurveSplitter({points, curveIndex, maxGap}).pieces();
}

}   // namespace angiopose::core
