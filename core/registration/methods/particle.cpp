#include "core/registration/methods/methods.h"

#include "core/registration/methods/kernel_finish.h"
#include "core/registration/pnp/sparse_kernel.h"
#include "core/registration/pose/pose_parameters.h"
#include "core/support/cell_index.h"
#include "core/support/random.h"
#include "core/support/stopwatch.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <numbers>

namespace angiopose::core {
namespace {

constexpr std::size_t sparsePoints = 150;
constexpr double likelihoodScalePx = 6.0;
constexpr double likelihoodSharpness = 60.0;
constexpr double spreadDecay = 0.75;
constexpr int stepsPerSurvivor = 2;
constexpr int cellsToEachSide = 3;
constexpr double cellDeg = 5.0;
constexpr int stepsPerCell = 12;
constexpr std::size_t finalistParticles = 3;

struct Scored {
    CentroidPose pose;
    double agreement = 0.0;
};

void sortBestFirst(std::vector<Scored>& poses)
{
    std::stable_sort(poses.begin(), poses.end(),
                     [](const Scored& a, const Scored& b) { return a.agreement > b.agreement; });
}

class ParticleSearch {
public:
    ParticleSearch(const RegistrationProblem& problem, const RegistrationOptions& options, ProgressLog& progress)
        : problem_(problem), options_(options), kernel_(problem, sparsePoints), search_(problem, budget(), progress)
    {
    }

    std::vector<Scored> filterParticles();
    std::vector<Scored> sweepOutOfPlane();
    void refine(const std::vector<Scored>& best);
    MethodSolution solution() const { return search_.solution(StopReason::Converged); }

private:
    int budget() const
    {
        constexpr int across = 2 * cellsToEachSide + 1;
        return options_.particle.search == ParticleSearchKind::OutOfPlane
                   ? across * across
                   : options_.particle.count * options_.particle.rounds;
    }
    Scored scoredPose(const CentroidPose& pose)
    {
        const double agreement = kernel_.agreement(pose, likelihoodScalePx);
        search_.recordTrial(pose, -agreement);
        return {pose, agreement};
    }
    std::vector<Scored> resample(const std::vector<Scored>& particles, CounterRandom& random) const;
    CentroidPose solvedInPlane(CentroidPose pose);

    const RegistrationProblem& problem_;
    const RegistrationOptions& options_;
    SparseKernel kernel_;
    PoseTrials search_;
};

/// Scatters particles, improves them by a few ascent steps and resamples them by likelihood, with decreasing spread.
std::vector<Scored> ParticleSearch::filterParticles()
{
    CounterRandom random(static_cast<std::uint64_t>(options_.randomSeed));
    const Vector6d spread = clinicalUnits(1.5, 2.0, 4.0, 8.0);
    std::vector<Scored> particles(static_cast<std::size_t>(options_.particle.count), scoredPose(search_.start()));
    double width = 1.0;
    for (int round = 0; round < options_.particle.rounds && !search_.isStopped(); ++round, width *= spreadDecay) {
        for (Scored& particle : particles) {
            Vector6d step;
            for (double& value : step) {
                value = width * random.normal();
            }
            CentroidPose pose = problem_.freedom.retract(particle.pose, step.cwiseProduct(spread));
            for (int k = 0; k < stepsPerSurvivor; ++k) {
                pose = kernel_.gaussNewtonStep(pose, likelihoodScalePx, false);
            }
            particle = scoredPose(pose);
            if (search_.isStopped()) {
                return {};
            }
        }
        particles = resample(particles, random);
    }
    sortBestFirst(particles);
    return particles;
}

/// Resamples systematically: one random offset, then even spacing.
std::vector<Scored> ParticleSearch::resample(const std::vector<Scored>& particles, CounterRandom& random) const
{
    double best = 0.0;
    for (const Scored& particle : particles) {
        best = std::max(best, particle.agreement);
    }
    std::vector<double> upTo;
    double sum = 0.0;
    for (const Scored& particle : particles) {
        sum += std::exp(likelihoodSharpness * (particle.agreement - best));
        upTo.push_back(sum);
    }
    std::vector<Scored> drawn;
    const double first = random.uniform();
    const auto count = static_cast<double>(particles.size());
    std::size_t k = 0;
    for (std::size_t i = 0; i < particles.size(); ++i) {
        while (k + 1 < particles.size() && upTo[k] < (static_cast<double>(i) + first) / count * sum) {
            ++k;
        }
        drawn.push_back(particles[k]);
    }
    return drawn;
}

CentroidPose ParticleSearch::solvedInPlane(CentroidPose pose)
{
    const double ratio = std::pow(likelihoodScalePx / 40.0, 1.0 / (stepsPerCell - 1));
    double scalePx = 40.0;
    for (int k = 0; k < stepsPerCell; ++k, scalePx *= ratio) {
        pose = kernel_.gaussNewtonStep(pose, scalePx, true);
    }
    return pose;
}

/// Sweeps the two out-of-plane angles, in which local optima mainly differ, from the initial pose outward and solves
/// for the other parameters in each cell. Continues to the neighbors of a cell only if it beats all previous cells.
std::vector<Scored> ParticleSearch::sweepOutOfPlane()
{
    constexpr int across = 2 * cellsToEachSide + 1;
    constexpr auto cellCount = static_cast<std::size_t>(across) * across;
    constexpr double perDeg = std::numbers::pi / 180.0;
    struct Cell {
        int x;
        int y;
        CentroidPose from;
    };
    std::array<bool, cellCount> isSeen{};
    std::deque<Cell> queue{{cellsToEachSide, cellsToEachSide, search_.start()}};
    isSeen[cellIndex(cellsToEachSide, across, cellsToEachSide)] = true;
    std::vector<Scored> solved;
    double best = -1.0;
    while (!queue.empty() && !search_.isStopped()) {
        const Cell cell = queue.front();
        queue.pop_front();
        solved.push_back(scoredPose(solvedInPlane(cell.from)));
        if (solved.back().agreement <= best) {
            continue;
        }
        best = solved.back().agreement;
        for (const auto& [dx, dy] : {std::pair{-1, 0}, {1, 0}, {0, -1}, {0, 1}, {-1, -1}, {1, 1}, {-1, 1}, {1, -1}}) {
            const int x = cell.x + dx;
            const int y = cell.y + dy;
            const bool isInside = x >= 0 && y >= 0 && x < across && y < across;
            const bool isFree = (dx == 0 || !problem_.freedom.isLocked(PoseAxis::CraCau)) &&
                                (dy == 0 || !problem_.freedom.isLocked(PoseAxis::LaoRao));
            const std::size_t number = isInside ? cellIndex(y, across, x) : 0;
            if (isInside && isFree && !isSeen[number]) {
                isSeen[number] = true;
                Vector6d turn = Vector6d::Zero();
                turn.head<2>() = cellDeg * perDeg * Eigen::Vector2d(dx, dy);
                queue.push_back({x, y, problem_.freedom.retract(solved.back().pose, turn)});
            }
        }
    }
    sortBestFirst(solved);
    return solved;
}

/// Refines the best few poses with all points to convergence; keeps the best fit.
void ParticleSearch::refine(const std::vector<Scored>& best)
{
    std::vector<CentroidPose> finalists;
    for (std::size_t i = 0; i < std::min(finalistParticles, best.size()); ++i) {
        finalists.push_back(best[i].pose);
    }
    refineByKernel(problem_, finalists, options_.finalScalePx, search_);
}

}   // namespace

MethodSolution solveParticle(const RegistrationProblem& problem, const RegistrationOptions& options,
                             ProgressLog& progress)
{
    Stopwatch stopwatch;
    ParticleSearch search(problem, options, progress);
    const double targetMs = stopwatch.takeLapMs();
    search.refine(options.particle.search == ParticleSearchKind::OutOfPlane ? search.sweepOutOfPlane()
                                                                            : search.filterParticles());
    MethodSolution solution = search.solution();
    solution.time.targetMs = targetMs;
    solution.time.solveMs = stopwatch.takeLapMs();
    return solution;
}

}   // namespace angiopose::core
