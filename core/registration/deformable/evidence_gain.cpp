#include "core/registration/deformable/evidence_gain.h"

#include <algorithm>
#include <array>
#include <limits>

namespace angiopose::core {
namespace {

constexpr std::array<double, 7> noiseFactorsTried{1.0, 1.4, 2.0, 2.8, 4.0, 8.0, 16.0};

}   // namespace

double logEvidenceGain(const BendProblem& problem, const BendFit& fit)
{
    if (!fit.posterior()) {
        return 0.0;
    }
    MotionPrior rigid = problem.prior;
    rigid.motion = {};
    double best = -std::numeric_limits<double>::infinity();
    for (const double factor : noiseFactorsTried) {
        std::vector<MotionRow> rows = fit.rows();
        for (MotionRow& row : rows) {
            row.variance *= factor * factor;
        }
        const double evidence = FieldPosterior(problem.kernel, rigid, std::move(rows)).logEvidence();
        if (evidence < best) {
            break;   // beyond the noise that suits it
        }
        best = evidence;
    }
    return fit.posterior()->logEvidence() - best;
}

}   // namespace angiopose::core
