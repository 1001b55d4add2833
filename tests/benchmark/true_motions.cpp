#include "tests/benchmark/true_motions.h"

#include "core/support/format_number.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <queue>

namespace angiopose::benchmarks {
namespace {

using Field = std::function<Eigen::Vector3d(const Eigen::Vector3d&)>;

Eigen::Vector3d normals(core::CounterRandom& random)
{
    return {random.normal(), random.normal(), random.normal()};
}

/// A sum of plane waves: many with normally distributed wave vectors approximate a Gaussian field, a few are waves.
Field planeWaves(int count, const std::function<Eigen::Vector3d()>& waveVector, core::CounterRandom& random)
{
    std::vector<std::pair<Eigen::Vector3d, Eigen::Vector4d>> waves;
    for (int k = 0; k < count; ++k) {
        const Eigen::Vector3d vector = waveVector();
        const Eigen::Vector3d amplitude = normals(random);
        waves.push_back({vector, {amplitude.x(), amplitude.y(), amplitude.z(), random.uniform(0.0, 6.28)}});
    }
    return [waves](const Eigen::Vector3d& place) {
        Eigen::Vector3d sum = Eigen::Vector3d::Zero();
        for (const auto& [vector, wave] : waves) {
            sum += std::cos(vector.dot(place) + wave.w()) * wave.head<3>();
        }
        return sum;
    };
}

core::VesselTree movedBy(const core::VesselTree& tree, const Field& field, double factor)
{
    core::VesselTree deformed = tree;
    for (core::VesselBranch& branch : deformed.branches) {
        for (Eigen::Vector3d& point : branch.pointsInPatient) {
            point += factor * field(point);
        }
    }
    return deformed;
}

double rmsOf(const core::VesselTree& tree, const Field& field)
{
    double sum = 0.0;
    for (const core::VesselBranch& branch : tree.branches) {
        for (const Eigen::Vector3d& point : branch.pointsInPatient) {
            sum += field(point).squaredNorm();
        }
    }
    return std::sqrt(sum / static_cast<double>(tree.pointCount()));
}

std::pair<double, double> heightsOf(const core::VesselTree& tree)
{
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (const core::VesselBranch& branch : tree.branches) {
        for (const Eigen::Vector3d& point : branch.pointsInPatient) {
            low = std::min(low, point.z());
            high = std::max(high, point.z());
        }
    }
    return {low, high};
}

/// All points of a tree and the paths between them.
struct PointGraph {
    explicit PointGraph(const core::VesselTree& tree)
    {
        for (const core::VesselBranch& branch : tree.branches) {
            for (const Eigen::Vector3d& point : branch.pointsInPatient) {
                points.push_back(point);
            }
        }
        neighbors.resize(points.size());
        std::size_t first = 0;
        for (const core::VesselBranch& branch : tree.branches) {
            const std::size_t end = first + branch.pointsInPatient.size();
            for (std::size_t k = first; k + 1 < end; ++k) {
                join(k, k + 1);
            }
            for (const std::size_t tip : {first, end - 1}) {
                for (std::size_t k = 0; k < points.size(); ++k) {
                    if ((k < first || k >= end) && (points[k] - points[tip]).norm() < 1.0) {
                        join(k, tip);
                    }
                }
            }
            first = end;
        }
    }

    void join(std::size_t a, std::size_t b)
    {
        neighbors[a].push_back(b);
        neighbors[b].push_back(a);
    }

    /// Path lengths from a point, and the predecessor of each point on its path (itself at the start).
    std::pair<std::vector<double>, std::vector<std::size_t>> waysFrom(std::size_t start) const
    {
        std::vector<double> lengths(points.size(), std::numeric_limits<double>::infinity());
        std::vector<std::size_t> before(points.size(), start);
        using Entry = std::pair<double, std::size_t>;
        std::priority_queue<Entry, std::vector<Entry>, std::greater<>> waiting;
        lengths[start] = 0.0;
        waiting.push({0.0, start});
        while (!waiting.empty()) {
            const auto [length, at] = waiting.top();
            waiting.pop();
            for (const std::size_t next : neighbors[at]) {
                const double longer = length + (points[next] - points[at]).norm();
                if (length <= lengths[at] && longer < lengths[next]) {
                    lengths[next] = longer;
                    before[next] = at;
                    waiting.push({longer, next});
                }
            }
        }
        return {lengths, before};
    }

    static std::size_t farthest(const std::vector<double>& lengths)
    {
        std::size_t best = 0;
        for (std::size_t k = 0; k < lengths.size(); ++k) {
            if (std::isfinite(lengths[k]) && (!std::isfinite(lengths[best]) || lengths[k] > lengths[best])) {
                best = k;
            }
        }
        return best;
    }

    std::vector<Eigen::Vector3d> points;
    std::vector<std::vector<std::size_t>> neighbors;
};

/// Deforms the tree by a stiff guidewire, which pushes the longest path through it to one side; branches off the path
/// are carried along.
core::VesselTree deformedByWire(const core::VesselTree& tree, double sizeMm, core::CounterRandom& random)
{
    const PointGraph graph(tree);
    const std::size_t begin = PointGraph::farthest(graph.waysFrom(0).first);
    const auto [lengths, before] = graph.waysFrom(begin);
    const std::size_t end = PointGraph::farthest(lengths);
    const Eigen::Vector3d chord = graph.points[end] - graph.points[begin];
    const Eigen::Vector3d aside = chord.cross(normals(random)).normalized();
    std::vector<double> share(graph.points.size(), -1.0);   // fraction of the path, for points of the guidewire
    for (std::size_t k = end; k != begin; k = before[k]) {
        share[k] = lengths[k] / lengths[end];
    }
    share[begin] = 0.0;
    core::VesselTree deformed = tree;
    std::size_t number = 0;
    for (core::VesselBranch& branch : deformed.branches) {
        for (Eigen::Vector3d& point : branch.pointsInPatient) {
            std::size_t root = number++;
            while (share[root] < 0.0 && root != begin) {
                root = before[root];
            }
            point += sizeMm * std::sin(std::numbers::pi * share[root]) * aside;
        }
    }
    return deformed;
}

}   // namespace

std::string TrueMotion::name() const
{
    const std::string size = core::plainText(sizeMm) + " mm";
    switch (form) {
        case Form::None:
            return "rigid";
        case Form::Field:
            return "field " + core::plainText(lengthMm) + " mm, " + size;
        case Form::Waves:
            return "waves " + core::plainText(6.0 * lengthMm) + " mm, " + size;
        case Form::Breathing:
            return "breathing to " + size;
        case Form::Wire:
            return "wire, " + size;
        case Form::Half:
            return "one half, " + size;
    }
    return "";
}

core::VesselTree deformedBy(const core::VesselTree& tree, const TrueMotion& motion, core::CounterRandom random)
{
    const auto [low, high] = heightsOf(tree);
    const double rangeMm = high - low;
    switch (motion.form) {
        case TrueMotion::Form::None:
            return tree;
        case TrueMotion::Form::Field: {
            const Field field = planeWaves(
                300, [&] { return Eigen::Vector3d(normals(random) / motion.lengthMm); }, random);
            return movedBy(tree, field, motion.sizeMm / rmsOf(tree, field));
        }
        case TrueMotion::Form::Waves: {
            const Field field = planeWaves(
                3,
                [&] {
                    const double wave = 6.0 * motion.lengthMm * random.uniform(0.75, 1.25);
                    return Eigen::Vector3d(normals(random).normalized() * 2.0 * std::numbers::pi / wave);
                },
                random);
            return movedBy(tree, field, motion.sizeMm / rmsOf(tree, field));
        }
        case TrueMotion::Form::Breathing:
            return movedBy(
                tree,
                [=](const Eigen::Vector3d& place) {
                    const double share = std::pow(std::clamp((high - place.z()) / rangeMm, 0.0, 1.0), 1.3);
                    return Eigen::Vector3d(0.0, -0.3 * share, -share);
                },
                motion.sizeMm);
        case TrueMotion::Form::Wire:
            return deformedByWire(tree, motion.sizeMm, random);
        case TrueMotion::Form::Half: {
            const Eigen::Vector3d aside = Eigen::Vector3d(random.normal(), random.normal(), 0.0).normalized();
            return movedBy(
                tree,
                [=](const Eigen::Vector3d& place) {
                    return Eigen::Vector3d(aside / (1.0 + std::exp((place.z() - 0.5 * (low + high)) / 2.0)));
                },
                motion.sizeMm);
        }
    }
    return tree;
}

}   // namespace angiopose::benchmarks
