#include "core/registration/pnp/pair_deformation.h"

#include "core/registration/pose/minimize.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace angiopose::core {
namespace {

constexpr double lengthWeight = 1.0;   // weight α of length changes, px²/mm²
constexpr double smoothWeight = 0.1;   // weight β of differences between neighbors, px²/mm²
constexpr double settledDeformationMm = 1e-4;
constexpr double settledDeformationShare = 1e-7;
constexpr double shortestLinkMm = 1e-6;

/// Link between two neighboring tree points.
struct Link {
    std::size_t a, b;
    double lengthMm;
};

std::vector<Link> linksOf(const TreeSamples& tree, const BranchGraph& graph)
{
    std::vector<Link> links;
    const auto join = [&](std::size_t a, std::size_t b) {
        links.push_back({a, b, (tree.points[a] - tree.points[b]).norm()});
    };
    for (std::size_t i = 1; i < tree.size(); ++i) {
        if (tree.branchIndex[i] == tree.branchIndex[i - 1]) {
            join(i - 1, i);
        }
    }
    for (const std::vector<EdgeEnd>& ends : graph.nodes) {
        const auto pointAt = [&](const EdgeEnd& end) {
            const BranchEdge& edge = graph.edges[static_cast<std::size_t>(end.edge)];
            return end.isReversed ? edge.to - 1 : edge.from;
        };
        for (std::size_t k = 1; k < ends.size(); ++k) {
            if (pointAt(ends[k]) != pointAt(ends.front())) {
                join(pointAt(ends.front()), pointAt(ends[k]));
            }
        }
    }
    return links;
}

/// Deformation energy as a function of all motions, three values per tree point.
class DeformationEnergy {
    /// Returns the three values of one point.
    template <class Vector>
    static auto part(Vector& all, std::size_t point)
    {
        return all.template segment<3>(3 * static_cast<Eigen::Index>(point));
    }

public:
    DeformationEnergy(const RegistrationProblem& problem, const BranchGraph& graph, const CentroidPose& pose,
                      const std::vector<BranchPair>& pairs)
        : problem_(problem), pose_(pose), pairs_(pairs), links_(linksOf(problem.tree, graph))
    {
    }

    Eigen::Index size() const { return 3 * static_cast<Eigen::Index>(problem_.tree.size()); }

    double of(const Eigen::VectorXd& motion, Eigen::VectorXd& gradient) const
    {
        gradient.setZero(motion.size());
        double sum = 0.0;
        for (const BranchPair& pair : pairs_) {
            const Eigen::Vector3d place = inCamera(motion, pair.point);
            const auto pixel = project(problem_.camera, place);
            if (pixel) {
                const Eigen::Vector2d gap = *pixel - pair.pixel;
                sum += gap.squaredNorm();
                part(gradient, pair.point) +=
                    2.0 * pose_.rotation.transpose() * (projectionJacobian(problem_.camera, place).transpose() * gap);
            }
        }
        for (const Link& link : links_) {
            sum += addLink(link, motion, gradient);
        }
        return sum;
    }

    /// Returns the median distance of the pairs, px; infinite if most points do not project.
    double medianPx(const Eigen::VectorXd& motion) const
    {
        std::vector<double> distances;
        for (const BranchPair& pair : pairs_) {
            const auto pixel = project(problem_.camera, inCamera(motion, pair.point));
            distances.push_back(pixel ? (*pixel - pair.pixel).norm() : std::numeric_limits<double>::infinity());
        }
        const auto middle = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 2);
        std::nth_element(distances.begin(), middle, distances.end());
        return *middle;
    }

private:
    Eigen::Vector3d inCamera(const Eigen::VectorXd& motion, std::size_t point) const
    {
        return pose_.rotation * (problem_.tree.points[point] - problem_.tree.centroid + part(motion, point)) +
               pose_.centroidInCamera;
    }

    double addLink(const Link& link, const Eigen::VectorXd& motion, Eigen::VectorXd& gradient) const
    {
        const Eigen::Vector3d change = part(motion, link.a) - part(motion, link.b);
        const Eigen::Vector3d way = problem_.tree.points[link.a] - problem_.tree.points[link.b] + change;
        const double length = way.norm();
        const double stretch = length - link.lengthMm;
        Eigen::Vector3d byA = 2.0 * smoothWeight * change;
        double cost = smoothWeight * change.squaredNorm();
        if (length > shortestLinkMm) {
            byA += 2.0 * lengthWeight * stretch / length * way;
            cost += lengthWeight * stretch * stretch;
        }
        part(gradient, link.a) += byA;
        part(gradient, link.b) -= byA;
        return cost;
    }

    const RegistrationProblem& problem_;
    const CentroidPose& pose_;
    const std::vector<BranchPair>& pairs_;
    std::vector<Link> links_;
};

}   // namespace

PairDeformation deformOntoPairs(const RegistrationProblem& problem, const BranchGraph& tree, const CentroidPose& pose,
                                const std::vector<BranchPair>& pairs, const std::function<bool()>& isStopped)
{
    PairDeformation deformation;
    deformation.motionMm.assign(problem.tree.size(), Eigen::Vector3d::Zero());
    if (pairs.empty()) {
        return deformation;
    }
    const DeformationEnergy energy(problem, tree, pose, pairs);
    MinimizeOptions lbfgs;
    lbfgs.minimizer = Minimizer::Lbfgs;
    lbfgs.tolerance = settledDeformationMm;
    lbfgs.relativeTolerance = settledDeformationShare;
    lbfgs.maxEvaluations = deformationEvaluations;
    const Eigen::VectorXd still = Eigen::VectorXd::Zero(energy.size());
    const Minimum minimum =
        minimize([&](const Eigen::VectorXd& motion, Eigen::VectorXd& gradient) { return energy.of(motion, gradient); },
                 still, lbfgs, isStopped);
    double squares = 0.0;
    for (std::size_t i = 0; i < deformation.motionMm.size(); ++i) {
        deformation.motionMm[i] = minimum.x.segment<3>(3 * static_cast<Eigen::Index>(i));
        squares += deformation.motionMm[i].squaredNorm();
        deformation.maxMotionMm = std::max(deformation.maxMotionMm, deformation.motionMm[i].norm());
    }
    deformation.rmsMm = std::sqrt(squares / static_cast<double>(deformation.motionMm.size()));
    deformation.medianBeforePx = energy.medianPx(still);
    deformation.medianPx = energy.medianPx(minimum.x);
    return deformation;
}

}   // namespace angiopose::core
