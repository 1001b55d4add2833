#include "core/registration/methods/methods.h"

#include "core/imaging/image_filters.h"
#include "core/imaging/mask_morphology.h"
#include "core/registration/methods/pose_trials.h"
#include "core/registration/picture/drr.h"
#include "core/registration/picture/rank_correlation.h"
#include "core/registration/picture/vessel_image.h"
#include "core/registration/pose/minimize.h"
#include "core/registration/pose/pose_parameters.h"
#include "core/support/random.h"
#include "core/support/stopwatch.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace angiopose::core {
namespace {

// Stage of the search; lengths in px at half resolution. The published method has a single stage; the blurred stage
// before it widens the capture range. Each stage samples its own mask pixels.
struct MaskStage {
    double blurPx = 0.0;
    double depthHold = 0.0;   ///< cost of a shift by depthStdMm along the ray, which a blurred view does not constrain
    double share = 1.0;   ///< fraction of the total evaluations
};
constexpr std::array<MaskStage, 2> maskStages{{{8.0, 0.05, 0.3}, {0.0, 0.01, 0.7}}};
constexpr double maskDepthStdMm = 30.0;
constexpr std::size_t fewestPixels = 2000;
constexpr double minGain = 1e-3;   // minimum gain in correlation that justifies another simplex
constexpr double settledSimplex = 0.005;   // final size relative to the initial simplex: 0.02°, 0.04 mm

/// Returns the indices of the covered pixels and of a margin around them.
std::vector<std::size_t> around(const ImageF& covered, double marginPx)
{
    Mask2d mask(covered.width, covered.height);
    std::transform(covered.pixels.begin(), covered.pixels.end(), mask.pixels.begin(),
                   [](float value) { return static_cast<std::uint8_t>(value > 0.0F ? 255 : 0); });
    mask = dilate(mask, std::max(1, static_cast<int>(std::lround(marginPx))));
    std::vector<std::size_t> pixels;
    for (std::size_t i = 0; i < mask.pixels.size(); ++i) {
        if (mask.pixels[i] != 0) {
            pixels.push_back(i);
        }
    }
    return pixels;
}

/// Similarity between the image and simulated DRRs over a fixed random sample of the mask pixels.
class MaskedSimilarity {
public:
    MaskedSimilarity(const RegistrationProblem& problem, const RegistrationOptions& options)
        : options_(options), drr_(problem), picture_(halveSize(vesselImage(problem)))
    {
    }

    /// Blurs the images to compare, and sets the mask to the area that the vessels cover at the given poses and a
    /// margin.
    void beginStage(double blurPx, const std::vector<RigidTransform>& poses);

    double of(const RigidTransform& pose) const
    {
        return rankCorrelation(drawn(gaussianBlur(drr_.from(pose), blurPx_)), shown_);
    }

private:
    std::vector<float> drawn(const ImageF& image) const;

    const RegistrationOptions& options_;
    Drr drr_;
    ImageF picture_;
    double blurPx_ = 0.0;
    std::vector<std::size_t> pixels_;
    std::vector<float> shown_;
};

void MaskedSimilarity::beginStage(double blurPx, const std::vector<RigidTransform>& poses)
{
    blurPx_ = blurPx;
    ImageF covered(picture_.width, picture_.height);
    for (const RigidTransform& pose : poses) {
        const ImageF drr = drr_.from(pose);
        std::transform(covered.pixels.begin(), covered.pixels.end(), drr.pixels.begin(), covered.pixels.begin(),
                       [](float a, float b) { return a + b; });
    }
    const std::vector<std::size_t> mask = around(covered, 0.5 * options_.automask.marginPx + 2.0 * blurPx);
    const double share = std::max(0.01 * options_.automask.sample,
                                  static_cast<double>(fewestPixels) / static_cast<double>(mask.size() + 1));
    pixels_.clear();
    // Samples each pixel by its index alone, which preserves the sample when the mask grows.
    const CounterRandom random(static_cast<std::uint64_t>(options_.randomSeed));
    for (const std::size_t pixel : mask) {
        if (random.fork(pixel).uniform() < share) {
            pixels_.push_back(pixel);
        }
    }
    shown_ = drawn(gaussianBlur(picture_, blurPx));
}

std::vector<float> MaskedSimilarity::drawn(const ImageF& image) const
{
    std::vector<float> values;
    values.reserve(pixels_.size());
    for (const std::size_t pixel : pixels_) {
        values.push_back(image.pixels[pixel]);
    }
    return values;
}

struct SimplexDescent {
    double blurPx = 0.0;
    double depthHold = 0.0;
    double firstStep = 1.0;
    int budget = 0;   ///< maximum number of evaluations
};

/// Restarts the simplex search at the previous result, with a new mask each time, until the gain is negligible, because
/// a collapsed simplex alone does not prove a maximum. Returns true if it ended for lack of gain.
bool descend(const RegistrationProblem& problem, MaskedSimilarity& similarity, const SimplexDescent& descent,
             PoseTrials& search)
{
    MinimizeOptions simplex;
    simplex.tolerance = settledSimplex;
    simplex.firstStep = descent.firstStep;
    int left = descent.budget;
    while (left > 0 && !search.isStopped()) {
        similarity.beginStage(descent.blurPx, {problem.start, search.rigidPose(search.best())});
        search.startStage("radiographs", 0.0, std::numeric_limits<double>::infinity());
        const PoseParameters parameters(search.best(), clinicalUnits(4.0, 4.0, 8.0, 20.0), problem.freedom);
        double costAtFirst = std::numeric_limits<double>::infinity();
        const auto cost = [&](const Eigen::VectorXd& x, Eigen::VectorXd&) {
            --left;
            const CentroidPose pose = parameters.pose(x);
            const double away = (pose.centroidInCamera.z() - search.start().centroidInCamera.z()) / maskDepthStdMm;
            const double value =
                search.recordTrial(pose, descent.depthHold * away * away - similarity.of(search.rigidPose(pose)));
            costAtFirst = std::isinf(costAtFirst) ? value : costAtFirst;
            return value;
        };
        simplex.maxEvaluations = left;
        minimize(cost, parameters.origin(), simplex, [&] { return search.isStopped(); });
        if (costAtFirst - search.bestCost() < minGain) {
            return true;
        }
        simplex.firstStep *= 0.7;
    }
    return false;
}

}   // namespace

MethodSolution solveAutoMask(const RegistrationProblem& problem, const RegistrationOptions& options,
                             ProgressLog& progress)
{
    Stopwatch stopwatch;
    MaskedSimilarity similarity(problem, options);
    const double targetMs = stopwatch.takeLapMs();

    PoseTrials search(problem, options.automask.evaluations, progress);
    bool isConverged = false;
    double firstStep = 1.0;
    for (const auto& [blurPx, depthHold, share] : maskStages) {
        const int budget = std::max(1, static_cast<int>(share * options.automask.evaluations));
        isConverged = descend(problem, similarity, {blurPx, depthHold, firstStep, budget}, search);
        firstStep *= 0.5;
    }
    MethodSolution solution = search.solution(isConverged ? StopReason::Converged : StopReason::IterationLimit);
    solution.time.targetMs = targetMs;
    solution.time.solveMs = stopwatch.takeLapMs();
    return solution;
}

}   // namespace angiopose::core
