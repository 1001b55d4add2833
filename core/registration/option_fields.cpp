#include "core/registration/option_field_makers.h"

namespace angiopose::core {
namespace {

using namespace option_fields;
using MethodIds = std::vector<std::string_view>;

const MethodIds ours{"angiopose"};
const MethodIds seeds{"dynaweight", "iterative-pnp"};
const MethodIds nicps{"nicp", "nicp-alternating"};
const MethodIds icps{"dt-icp", "assembled-icp"};
const MethodIds kernels{"dynaweight", "iterative-pnp", "nicp", "nicp-alternating"};
const MethodIds pointBased{"dynaweight", "iterative-pnp", "nicp", "nicp-alternating", "dt-icp", "assembled-icp"};
const MethodIds alternating{"dynaweight", "nicp-alternating", "dt-icp", "assembled-icp"};
const MethodIds turning{"dynaweight", "nicp-alternating", "dt-icp"};
const MethodIds chance{"dynaweight", "nicp-alternating", "dt-icp",    "assembled-icp",
                       "rgbr",       "automask",         "evolution", "particle"};
const std::vector<std::string_view> offOn{"off", "on"};

/// What every method or several read.
std::vector<OptionField> commonFields()
{
    return {
        within(
            number<&Options::pointSpacingMm>("pointSpacingMm", "Tree point spacing", "mm",
                                             "Distance between the tree points that are matched; smaller is slower."),
            0.2, 5.0, 2),
        within(number<&Options::targetSpacingPx>("targetSpacingPx", "Image point spacing", "px",
                                                 "Distance between the points of the traced vessels."),
               0.25, 5.0, 2),
        choice(number<&Options::resample>("resample", "Even spacing", "",
                                          "Spreads the points evenly before matching; off takes them as they are."),
               offOn),
        within(number<&Options::maxIterations>("maxIterations", "Iterations at most", "",
                                               "The refinement ends after so many steps."),
               1, 1000, 0),
        within(number<&Options::finalScalePx>(
                   "finalScalePx", "Final scale", "px",
                   "Distance beyond which a point hardly counts in the end; the noise of the image may widen it."),
               0.1, 20.0, 2),
    };
}

/// The seed's methods, and what those built like them share.
std::vector<OptionField> seedFields()
{
    return {
        onlyFor(kernels,
                choice(number<&Options::preset>("preset", "Prior", "",
                                                "How the pull towards the start pose is weighed against the image."),
                       {"seed_sum", "seed_mean", "seed_metric", "seed_noprior"})),
        onlyFor(kernels, within(number<&Options::priorWeight>("priorWeight", "Prior weight", "",
                                                              "Strength of the pull towards the start pose."),
                                0.0, 1e6, 2)),
        onlyFor(turning, choice(number<&Options::rotationFirst>("rotationFirst", "Rotation first", "",
                                                                "Turns about the source before all else."),
                                offOn)),
        onlyFor({"dynaweight"},
                choice(number<&Options::alternation>("alternation", "Alternation", "",
                                                     "Lets the auxiliary and the full problem take turns."),
                       offOn)),
        onlyFor(pointBased,
                choice(number<&Options::index>("index", "Nearest points", "",
                                               "How they are found: the tree and the grid are exact, the map "
                                               "is right to within three pixels."),
                       {"kd-tree", "grid", "map"})),
        onlyFor(seeds, choice(number<&Options::startScale>("startScale", "Start scale", "",
                                                           "Kernel width at first: the largest distance, or its square "
                                                           "as the paper prints it."),
                              {"largest", "largest_squared"})),
        onlyFor(seeds, choice(number<&Options::decay>("decay", "Kernel decay", "",
                                                      "Narrows the kernel after five steps, or once no further point "
                                                      "comes within its reach."),
                              {"halving", "stagnation"})),
    };
}

/// Matching and the alternating search.
std::vector<OptionField> alternatingFields()
{
    return {
        onlyFor(kernels, choice(number<&Options::neighbours>("neighbours", "Neighbours", "",
                                                             "Image points that pull each tree point: the nearest, the "
                                                             "five nearest, or all within three kernel widths."),
                                {"closest", "five", "radius"})),
        onlyFor(icps, choice(number<&Options::alternate>("alternate", "Alternating search", "",
                                                         "Lets the auxiliary points and all points take turns."),
                             offOn)),
        onlyFor(alternating,
                choice(number<&Options::auxiliary>("auxiliary", "Auxiliary points", "",
                                                   "Chosen branches (nodes where none is chosen), nodes, the widest "
                                                   "branches up to a third of the length, or random points."),
                       {"chosen", "nodes", "main_branches", "random"})),
        onlyFor(alternating,
                within(number<&Options::auxiliaryCount>("auxiliaryCount", "Random points", "",
                                                        "How many, where the auxiliary points are random."),
                       4, 2000, 0)),
    };
}

/// Our own solver.
std::vector<OptionField> solverFields()
{
    return {
        onlyFor(ours, choice(number<&Options::search>("search", "Search", "",
                                                      "Looks for the pose around the start before refining it."),
                             offOn)),
        onlyFor(ours, within(number<&Options::searchRadiusMm>("searchRadiusMm", "Search radius", "mm",
                                                              "How far across the ray the search reaches."),
                             0.0, 200.0, 0)),
        onlyFor(ours, within(number<&Options::searchTiltDeg>("searchTiltDeg", "Search tilt", "°",
                                                             "How far the search reaches in LAO/RAO and CRA/CAU."),
                             0.0, 90.0, 1)),
        onlyFor(ours, within(number<&Options::searchRollDeg>("searchRollDeg", "Search roll", "°",
                                                             "How far the search turns the vessels in the image."),
                             0.0, 180.0, 1)),
        onlyFor(ours, within(number<&Options::priorRotationDeg>(
                                 "priorRotationDeg", "Start rotation ±", "°",
                                 "Standard deviation of the start pose's angles; holds what the image cannot tell."),
                             0.1, 90.0, 1)),
        onlyFor(ours, within(number<&Options::priorLateralMm>("priorLateralMm", "Start shift ±", "mm",
                                                              "Standard deviation of the start pose across the ray."),
                             0.1, 500.0, 1)),
        onlyFor(ours, within(number<&Options::priorDepthMm>("priorDepthMm", "Start depth ±", "mm",
                                                            "Standard deviation of the start pose along the ray."),
                             0.1, 500.0, 1)),
    };
}

/// Iterated closest points.
std::vector<OptionField> icpFields()
{
    return {
        onlyFor(icps, within(number<&Options::icpIterations>("icpIterations", "ICP iterations at most", "",
                                                             "Matching and solving end after so many rounds."),
                             1, 1000, 0)),
        onlyFor({"dt-icp"}, within(number<&Options::huberPx>("huberPx", "Huber distance", "px",
                                                             "Distance from which a point's pull stops growing."),
                                   0.5, 100.0, 1)),
        onlyFor({"dt-icp"}, choice(number<&Options::icpSolver>("icpSolver", "Solver", "",
                                                               "Damped steps on the Huber loss with fresh matches, or "
                                                               "L-BFGS on the squared distances."),
                                   {"lm", "lbfgs"})),
        onlyFor({"dt-icp"}, choice(number<&Options::icpModel>("icpModel", "Transformation", "",
                                                              "Rigid only, or an affine stage after it, of which the "
                                                              "rigid part is kept if it fits better."),
                                   {"rigid", "affine"})),
    };
}

/// Gradient ascent on kernels.
std::vector<OptionField> nicpFields()
{
    return {
        onlyFor({"nicp"},
                choice(number<&Options::nicpImage>("nicpImage", "Attracted by", "",
                                                   "The traced vessels, or the brightness of the image at each "
                                                   "vessel's own width."),
                       {"traced_vessels", "image"})),
        onlyFor(nicps, choice(number<&Options::nicpStep>("nicpStep", "Step", "",
                                                         "Turns and shifts in balance, or raw radians beside "
                                                         "millimetres, which hardly shifts."),
                              {"metric", "literal"})),
        onlyFor(nicps, choice(number<&Options::nicpPrior>("nicpPrior", "Pull to the start", "",
                                                          "Adds the prior chosen above to the attraction."),
                              offOn)),
        onlyFor(nicps, within(number<&Options::nicpStartScalePx>("nicpStartScalePx", "First kernel width", "px",
                                                                 "Reach of the attraction at first."),
                              1.0, 200.0, 1)),
        onlyFor(nicps, within(number<&Options::nicpFinalScalePx>("nicpFinalScalePx", "Last kernel width", "px",
                                                                 "Reach of the attraction in the end."),
                              0.1, 50.0, 1)),
        onlyFor(nicps, within(number<&Options::nicpIterations>("nicpIterations", "Steps per width", "",
                                                               "Gradient steps at each of the three widths at most."),
                              1, 2000, 0)),
    };
}

/// Methods that read the image.
std::vector<OptionField> imageFields()
{
    return {
        onlyFor({"rgbr"}, within(number<&Options::rgbrReachMm>("rgbrReachMm", "First reach", "mm",
                                                               "How far along the vessel walls' normals edges are "
                                                               "sought at first."),
                                 1.0, 50.0, 1)),
        onlyFor({"rgbr"}, within(number<&Options::rgbrHypotheses>("rgbrHypotheses", "Hypotheses", "",
                                                                  "Poses from three random correspondences per round."),
                                 10, 5000, 0)),
        onlyFor({"rgbr"}, within(number<&Options::rgbrRounds>("rgbrRounds", "Rounds at most", "",
                                                              "Matching and choosing a pose end after so many rounds."),
                                 1, 200, 0)),
        onlyFor({"automask"}, within(number<&Options::automaskSample>("automaskSample", "Pixels compared", "%",
                                                                      "Share of the mask that the rank correlation is "
                                                                      "taken over; at least 2000 pixels."),
                                     0.5, 100.0, 1)),
        onlyFor({"automask"}, within(number<&Options::automaskMarginPx>("automaskMarginPx", "Mask margin", "px",
                                                                        "How far the mask reaches beyond the projected "
                                                                        "vessels."),
                                     1.0, 100.0, 0)),
        onlyFor({"automask"}, within(number<&Options::automaskEvaluations>("automaskEvaluations", "Evaluations at most",
                                                                           "", "Radiographs computed at most."),
                                     10, 20000, 0)),
        onlyFor({"gradient-matching"},
                within(number<&Options::gradientScalePx>("gradientScalePx", "Edge scale", "px",
                                                         "Smoothing under the gradients of the image."),
                       0.5, 20.0, 1)),
        onlyFor({"gradient-matching"}, within(number<&Options::powellRounds>("powellRounds", "Rounds at most", "",
                                                                             "Line searches along all six directions."),
                                              1, 200, 0)),
    };
}

/// Mixtures and searches.
std::vector<OptionField> globalFields()
{
    return {
        onlyFor({"ogmm"}, within(number<&Options::ogmmStartScalePx>("ogmmStartScalePx", "First kernel width", "px",
                                                                    "Width of the mixtures' Gaussians at first."),
                                 0.5, 200.0, 1)),
        onlyFor({"ogmm"}, within(number<&Options::ogmmFinalScalePx>("ogmmFinalScalePx", "Last kernel width", "px",
                                                                    "Width of the mixtures' Gaussians in the end."),
                                 0.1, 50.0, 1)),
        onlyFor({"ogmm"}, within(number<&Options::ogmmOrientation>("ogmmOrientation", "Direction kernel", "",
                                                                   "How alike directions must be; small is strict."),
                                 0.05, 10.0, 2)),
        onlyFor({"ogmm"}, within(number<&Options::ogmmSelfWeight>("ogmmSelfWeight", "Self term", "",
                                                                  "Keeps the projected tree from shrinking; lower it "
                                                                  "where many branches are missing from the image."),
                                 0.0, 10.0, 2)),
        onlyFor({"evolution"}, choice(number<&Options::evolutionStrategy>("evolutionStrategy", "Strategy", "",
                                                                          "Covariance matrix adaptation, or one parent "
                                                                          "and one child at a time."),
                                      {"cma-es", "one_plus_one"})),
        onlyFor({"evolution"}, within(number<&Options::evolutionPopulation>("evolutionPopulation", "Population", "",
                                                                            "Poses tried per generation."),
                                      4, 500, 0)),
        onlyFor({"evolution"}, within(number<&Options::evolutionEvaluations>(
                                          "evolutionEvaluations", "Evaluations at most", "", "Poses tried in all."),
                                      10, 100000, 0)),
        onlyFor({"particle"}, choice(number<&Options::particleSearch>("particleSearch", "Search", "",
                                                                      "Annealed particles around the start, or a walk "
                                                                      "over the out-of-plane angles."),
                                     {"particles", "out_of_plane"})),
        onlyFor({"particle"}, within(number<&Options::particles>("particles", "Particles", "", "Poses kept per round."),
                                     10, 10000, 0)),
        onlyFor({"particle"}, within(number<&Options::particleRounds>("particleRounds", "Rounds", "",
                                                                      "The spread narrows by a quarter in each."),
                                     1, 50, 0)),
    };
}

/// Chance.
std::vector<OptionField> closingFields()
{
    return {
        onlyFor(chance, within(number<&Options::randomSeed>("randomSeed", "Random seed", "",
                                                            "Another number draws other lots; the same repeats them."),
                               1, 1000000, 0)),
    };
}

}   // namespace

const std::vector<OptionField>& optionFields()
{
    static const std::vector<OptionField> fields = [] {
        std::vector<OptionField> all;
        for (const auto make : {commonFields, seedFields, alternatingFields, solverFields, icpFields, nicpFields,
                                imageFields, globalFields, closingFields}) {
            const std::vector<OptionField> group = make();
            all.insert(all.end(), group.begin(), group.end());
        }
        return all;
    }();
    return fields;
}

}   // namespace angiopose::core