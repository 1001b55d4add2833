#include "core/registration/methods/methods.h"

#include "core/registration/pnp/alternating_search.h"
#include "core/support/stopwatch.h"

namespace angiopose::core {
namespace {

/// Kernel PnP in each problem; only the problem of all points uses the prior of the preset (ALGORITHMS §3.2).
class KernelSolver final : public PointSolver {
public:
    explicit KernelSolver(const SeedProblem& seed) : seed_(seed) {}

    KernelPnpResult solve(const KernelProblem& problem, SearchStage stage, const RigidTransform& start,
                          const KernelObserver& observe) override
    {
        KernelSchedule schedule = seed_.schedule;
        if (stage == SearchStage::Full) {
            return KernelPnp(problem, seed_.prior, schedule).solve(start, observe);
        }
        schedule.freedom = stage == SearchStage::Turn ? Freedom::Rotation : Freedom::Full;
        schedule.minDepthMm = seed_.minDepthMm;
        schedule.maxDepthMm = seed_.maxDepthMm;
        return KernelPnp(problem, {}, schedule).solve(start, observe);
    }

    /// Anneals each problem to the end: shorter runs (ALGORITHMS §3.2) stop at a wide kernel when ℓ starts at d².
    int maxIterations(SearchStage) const override { return seed_.schedule.maxIterations; }

private:
    const SeedProblem& seed_;
};

}   // namespace

MethodSolution solveDynaWeight(const RegistrationProblem& problem, const RegistrationOptions& options,
                               ProgressLog& progress)
{
    Stopwatch stopwatch;
    const SeedProblem seed = makeSeedProblem(problem, options);
    const double targetMs = stopwatch.takeLapMs();
    KernelSolver solver(seed);
    const Alternation alternation{options.seed.rotationFirst, options.seed.alternation};
    MethodSolution solution = searchAlternating(problem, options, seed, solver, alternation, progress);
    solution.time.targetMs = targetMs;
    return solution;
}

}   // namespace angiopose::core
