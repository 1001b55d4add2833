#include "core/registration/deformable/tree_matching.h"

#include <algorithm>
#include <cmath>
#include <ranges>

namespace angiopose::core {
namespace {

constexpr double unmatchedCost = 1.8;   // cost of an unmatched knot, equal to that of a candidate at the gate
constexpr double maxDifferenceCost = 6.0;   // upper limit, because of crossing vessels and wrong candidates
constexpr double appearCost = 2.0;   // cost if only one of two neighboring knots is matched
constexpr double otherCurveCost = 0.3;   // cost of switching curves between neighbors; traced curves break at crossings

/// Likelihoods of a knot's states, passed as messages: unmatched first, then the candidates.
using StateLikelihoods = Eigen::VectorXd;

StateLikelihoods ownLikelihoods(const KnotChoice& choice)
{
    StateLikelihoods own(static_cast<Eigen::Index>(choice.candidates.size()) + 1);
    own[0] = std::exp(-unmatchedCost);
    for (std::size_t c = 0; c < choice.candidates.size(); ++c) {
        own[static_cast<Eigen::Index>(c) + 1] = std::exp(-choice.candidates[c].cost);
    }
    return own;
}

/// Returns the likelihood of every pair of states, parent states in rows and child states in columns.
Eigen::MatrixXd pairLikelihoods(const KnotChoice& parent, const KnotChoice& child, double lengthMm,
                                const NeighborModel& model)
{
    const auto rows = static_cast<Eigen::Index>(parent.candidates.size()) + 1;
    const auto columns = static_cast<Eigen::Index>(child.candidates.size()) + 1;
    Eigen::MatrixXd pairs = Eigen::MatrixXd::Constant(rows, columns, std::exp(-appearCost));
    pairs(0, 0) = 1.0;
    const double cosine = parent.normal.dot(child.normal);
    const double turnSquared = 2.0 * (1.0 - std::abs(cosine));
    const double sign = cosine < 0.0 ? -1.0 : 1.0;
    const double change = model.strain * lengthMm;
    const double variance = model.noiseMm * model.noiseMm + change * change;
    for (Eigen::Index p = 1; p < rows; ++p) {
        const KnotCandidate& here = parent.candidates[static_cast<std::size_t>(p) - 1];
        for (Eigen::Index c = 1; c < columns; ++c) {
            const KnotCandidate& there = child.candidates[static_cast<std::size_t>(c) - 1];
            const double difference = here.offsetMm - sign * there.offsetMm;
            // On a curved vessel, each normal measures a different component of the motion.
            const double squares = 0.5 * (here.offsetMm * here.offsetMm + there.offsetMm * there.offsetMm);
            const double spread = 2.0 * (variance + squares * turnSquared);
            const double cost = std::min(maxDifferenceCost, difference * difference / spread) +
                                (here.curve != there.curve ? otherCurveCost : 0.0);
            pairs(p, c) = std::exp(-cost);
        }
    }
    return pairs;
}

}   // namespace

void matchAlongTree(const TreeKnots& knots, const NeighborModel& model, std::vector<KnotChoice>& choices)
{
    std::vector<StateLikelihoods> beliefs;
    for (const KnotChoice& choice : choices) {
        beliefs.push_back(ownLikelihoods(choice));
    }
    std::vector<Eigen::MatrixXd> pairs(knots.links.size());
    std::vector<StateLikelihoods> upwards(knots.links.size());
    for (std::size_t l = knots.links.size(); l-- > 0;) {
        const KnotLink& link = knots.links[l];
        pairs[l] = pairLikelihoods(choices[link.parent], choices[link.child], link.lengthMm, model);
        upwards[l] = pairs[l] * beliefs[link.child];
        upwards[l] /= upwards[l].maxCoeff();
        beliefs[link.parent].array() *= upwards[l].array();
        beliefs[link.parent] /= beliefs[link.parent].maxCoeff();
    }
    for (std::size_t l = 0; l < knots.links.size(); ++l) {
        const KnotLink& link = knots.links[l];
        const StateLikelihoods without = beliefs[link.parent].array() / upwards[l].array();
        beliefs[link.child].array() *= (pairs[l].transpose() * without).array();
        beliefs[link.child] /= beliefs[link.child].maxCoeff();
    }
    for (std::size_t k = 0; k < choices.size(); ++k) {
        const double sum = beliefs[k].sum();
        for (std::size_t c = 0; c < choices[k].candidates.size(); ++c) {
            choices[k].candidates[c].probability = beliefs[k][static_cast<Eigen::Index>(c) + 1] / sum;
        }
    }
}

}   // namespace angiopose::core
