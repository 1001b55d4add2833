#include "core/registration/options/option_field_makers.h"
#include "core/registration/options/option_groups.h"

namespace angiopose::core::option_fields {
namespace {

using MethodIds = std::vector<std::string_view>;

const MethodIds seeds{"dynaweight", "iterative-pnp"};
const MethodIds nicps{"nicp", "nicp-alternating"};
const MethodIds icps{"dt-icp", "assembled-icp"};
const MethodIds kernels{"dynaweight", "iterative-pnp", "nicp", "nicp-alternating"};
const MethodIds pointBased{"dynaweight", "iterative-pnp", "nicp", "nicp-alternating", "dt-icp", "assembled-icp"};
const MethodIds alternating{"dynaweight", "nicp-alternating", "dt-icp", "assembled-icp"};
const MethodIds turning{"dynaweight", "nicp-alternating", "dt-icp"};

}   // namespace

std::vector<OptionField> seedFields()
{
    return {
        onlyFor(kernels, choice<&Options::seed, &SeedOptions::preset>(
                             {"preset", "Prior", "Weighting of the initial-pose prior relative to the image."},
                             {"seed_sum", "seed_mean", "seed_metric", "seed_noprior"})),
        onlyFor(kernels, number<&Options::seed, &SeedOptions::priorWeight>(
                             {"priorWeight", "Prior weight", "Weight of the initial-pose prior."}, {"", 0.0, 1e6, 2})),
        onlyFor(turning,
                toggle<&Options::seed, &SeedOptions::rotationFirst>(
                    {"rotationFirst", "Rotation first", "Rotates about the X-ray source before all other steps."})),
        onlyFor({"dynaweight"},
                toggle<&Options::seed, &SeedOptions::alternation>(
                    {"alternation", "Alternation", "Alternates between the auxiliary and the full problem."})),
        onlyFor(pointBased, choice<&Options::seed, &SeedOptions::index>(
                                {"index", "Nearest-point search",
                                 "Nearest-neighbor search: the k-d tree and the grid are exact; the distance map is "
                                 "accurate to within three pixels."},
                                {"kd-tree", "grid", "map"})),
        onlyFor(seeds,
                choice<&Options::seed, &SeedOptions::startScale>(
                    {"startScale", "Initial scale",
                     "Initial kernel width: the largest distance, or its square as printed in the original paper."},
                    {"largest", "largest_squared"})),
        onlyFor(seeds, choice<&Options::seed, &SeedOptions::decay>(
                           {"decay", "Kernel decay",
                            "Narrows the kernel after every five steps, or when no new point comes within its range."},
                           {"halving", "stagnation"})),
    };
}

std::vector<OptionField> alternatingFields()
{
    return {
        onlyFor(kernels, choice<&Options::seed, &SeedOptions::neighbors>(
                             {"neighbours", "Neighbors",
                              "Image points that attract each tree point: the nearest, the five nearest, or all within "
                              "three kernel widths."},
                             {"closest", "five", "radius"})),
        onlyFor(icps,
                toggle<&Options::icp, &IcpOptions::alternate>(
                    {"alternate", "Alternating search", "Alternates between the auxiliary points and all points."})),
        onlyFor(alternating, choice<&Options::seed, &SeedOptions::auxiliary>(
                                 {"auxiliary", "Auxiliary points",
                                  "Auxiliary branches (nodes if none are selected), nodes, the widest branches (up to "
                                  "one third of the total length), or random points."},
                                 {"chosen", "nodes", "main_branches", "random"})),
        onlyFor(alternating,
                count<&Options::seed, &SeedOptions::auxiliaryCount>(
                    {"auxiliaryCount", "Random points", "Number of auxiliary points if these are chosen at random."}, 4,
                    2000)),
    };
}

std::vector<OptionField> icpFields()
{
    return {
        onlyFor(icps, count<&Options::icp, &IcpOptions::iterations>(
                          {"icpIterations", "Max. ICP iterations", "Maximum number of rounds of matching and solving."},
                          1, 1000)),
        onlyFor({"dt-icp"}, number<&Options::icp, &IcpOptions::huberPx>(
                                {"huberPx", "Huber distance",
                                 "Distance beyond which the influence of a point no longer increases."},
                                {"px", 0.5, 100.0, 1})),
        onlyFor({"dt-icp"},
                choice<&Options::icp, &IcpOptions::solver>({"icpSolver", "Solver",
                                                            "Levenberg–Marquardt on the Huber loss with updated "
                                                            "correspondences, or L-BFGS on the squared distances."},
                                                           {"lm", "lbfgs"})),
        onlyFor({"dt-icp"},
                choice<&Options::icp, &IcpOptions::model>({"icpModel", "Transformation",
                                                           "Rigid only, or rigid followed by an affine stage whose "
                                                           "rigid component is adopted if it fits better."},
                                                          {"rigid", "affine"})),
    };
}

std::vector<OptionField> nicpFields()
{
    return {
        onlyFor({"nicp"}, choice<&Options::nicp, &NicpOptions::image>(
                              {"nicpImage", "Attracted to",
                               "The traced vessels, or the image intensity at the scale of each vessel."},
                              {"traced_vessels", "image"})),
        onlyFor(nicps, choice<&Options::nicp, &NicpOptions::step>(
                           {"nicpStep", "Step",
                            "Scaling of the gradient step: balanced between rotation and translation, or unscaled in "
                            "radians and millimeters, which yields hardly any translation."},
                           {"metric", "literal"})),
        onlyFor(nicps,
                toggle<&Options::nicp, &NicpOptions::prior>(
                    {"nicpPrior", "Initial-pose prior", "Adds the prior selected above to the attraction term."})),
        onlyFor(nicps, number<&Options::nicp, &NicpOptions::startScalePx>(
                           {"nicpStartScalePx", "Initial kernel width", "Initial range of the attraction."},
                           {"px", 1.0, 200.0, 1})),
        onlyFor(nicps, number<&Options::nicp, &NicpOptions::finalScalePx>(
                           {"nicpFinalScalePx", "Final kernel width", "Final range of the attraction."},
                           {"px", 0.1, 50.0, 1})),
        onlyFor(nicps, count<&Options::nicp, &NicpOptions::iterations>(
                           {"nicpIterations", "Steps per width",
                            "Maximum number of gradient steps at each of the three kernel widths."},
                           1, 2000)),
    };
}

std::vector<OptionField> imageFields()
{
    return {
        onlyFor({"rgbr"}, number<&Options::rgbr, &RgbrOptions::reachMm>(
                              {"rgbrReachMm", "Initial range",
                               "Initial search distance for edges along the normals of the vessel walls."},
                              {"mm", 1.0, 50.0, 1})),
        onlyFor({"rgbr"}, count<&Options::rgbr, &RgbrOptions::hypotheses>(
                              {"rgbrHypotheses", "Hypotheses",
                               "Number of poses per round, each computed from three random correspondences."},
                              10, 5000)),
        onlyFor({"rgbr"},
                count<&Options::rgbr, &RgbrOptions::rounds>(
                    {"rgbrRounds", "Max. rounds", "Maximum number of rounds of matching and pose selection."}, 1, 200)),
        onlyFor({"automask"},
                number<&Options::automask, &AutoMaskOptions::sample>(
                    {"automaskSample", "Compared pixels",
                     "Fraction of the mask used for the rank correlation; at least 2000 pixels are used."},
                    {"%", 0.5, 100.0, 1})),
        onlyFor({"automask"},
                number<&Options::automask, &AutoMaskOptions::marginPx>(
                    {"automaskMarginPx", "Mask margin", "Margin of the mask around the projected vessels."},
                    {"px", 1.0, 100.0, 0})),
        onlyFor({"automask"},
                count<&Options::automask, &AutoMaskOptions::evaluations>(
                    {"automaskEvaluations", "Max. evaluations", "Maximum number of DRRs computed."}, 10, 20000)),
        onlyFor({"gradient-matching"}, number<&Options::gradient, &GradientOptions::scalePx>(
                                           {"gradientScalePx", "Edge scale", "Smoothing scale of the image gradients."},
                                           {"px", 0.5, 20.0, 1})),
        onlyFor({"gradient-matching"}, count<&Options::gradient, &GradientOptions::powellRounds>(
                                           {"powellRounds", "Max. rounds",
                                            "Maximum number of rounds of line searches along all six directions."},
                                           1, 200)),
    };
}

std::vector<OptionField> globalFields()
{
    return {
        onlyFor({"ogmm"},
                number<&Options::ogmm, &OgmmOptions::startScalePx>(
                    {"ogmmStartScalePx", "Initial kernel width", "Initial width of the Gaussians in the mixture."},
                    {"px", 0.5, 200.0, 1})),
        onlyFor({"ogmm"},
                number<&Options::ogmm, &OgmmOptions::finalScalePx>(
                    {"ogmmFinalScalePx", "Final kernel width", "Final width of the Gaussians in the mixture."},
                    {"px", 0.1, 50.0, 1})),
        onlyFor({"ogmm"}, number<&Options::ogmm, &OgmmOptions::orientation>(
                              {"ogmmOrientation", "Direction kernel",
                               "Required similarity of directions; smaller values are stricter."},
                              {"", 0.05, 10.0, 2})),
        onlyFor({"ogmm"}, number<&Options::ogmm, &OgmmOptions::selfWeight>(
                              {"ogmmSelfWeight", "Self term",
                               "Prevents the projected tree from shrinking; lower the weight if many branches are "
                               "missing from the image."},
                              {"", 0.0, 10.0, 2})),
        onlyFor({"evolution"}, choice<&Options::evolution, &EvolutionOptions::strategy>(
                                   {"evolutionStrategy", "Strategy",
                                    "Covariance matrix adaptation (CMA-ES), or a (1+1) evolution strategy."},
                                   {"cma-es", "one_plus_one"})),
        onlyFor({"evolution"},
                count<&Options::evolution, &EvolutionOptions::population>(
                    {"evolutionPopulation", "Population", "Number of poses tested per generation."}, 4, 500)),
        onlyFor({"evolution"},
                count<&Options::evolution, &EvolutionOptions::evaluations>(
                    {"evolutionEvaluations", "Max. evaluations", "Maximum total number of poses tested."}, 10, 100000)),
        onlyFor({"particle"},
                choice<&Options::particle, &ParticleOptions::search>(
                    {"particleSearch", "Search",
                     "Annealed particles around the initial pose, or a sweep over the out-of-plane angles."},
                    {"particles", "out_of_plane"})),
        onlyFor({"particle"}, count<&Options::particle, &ParticleOptions::count>(
                                  {"particles", "Particles", "Number of poses retained per round."}, 10, 10000)),
        onlyFor({"particle"},
                count<&Options::particle, &ParticleOptions::rounds>(
                    {"particleRounds", "Rounds",
                     "Number of rounds; the spread of the particles decreases by one quarter in each round."},
                    1, 50)),
    };
}

std::vector<OptionField> flowFields()
{
    return {
        onlyFor({"cvo"}, number<&Options::cvo, &CvoOptions::startScalePx>(
                             {"cvoStartScalePx", "Initial kernel width", "Initial range of the attraction."},
                             {"px", 0.5, 200.0, 1})),
        onlyFor({"cvo"},
                number<&Options::cvo, &CvoOptions::finalScalePx>(
                    {"cvoFinalScalePx", "Final kernel width", "Final range of the attraction."}, {"px", 0.1, 50.0, 1})),
        onlyFor({"cvo"}, number<&Options::cvo, &CvoOptions::decay>(
                             {"cvoDecay", "Kernel decay",
                              "Factor by which the kernel width is multiplied in each step after the first thirty."},
                             {"", 0.5, 0.999, 3})),
        onlyFor({"cvo"}, count<&Options::cvo, &CvoOptions::iterations>(
                             {"cvoIterations", "Max. flow steps",
                              "Maximum number of steps along the flow, summed over all kernel widths."},
                             1, 5000)),
        onlyFor({"cvo"}, toggle<&Options::cvo, &CvoOptions::directions>(
                             {"cvoDirections", "Use directions",
                              "Points attract each other more strongly where the vessels run in similar directions."})),
    };
}

std::vector<OptionField> graphFields()
{
    return {
        onlyFor({"matched-branches"},
                number<&Options::branches, &BranchOptions::reachPx>(
                    {"branchReachPx", "Initial matching range",
                     "Initial maximum distance between a branch and the traced vessel matched to it."},
                    {"px", 5.0, 500.0, 1})),
        onlyFor({"matched-branches"},
                count<&Options::branches, &BranchOptions::rounds>(
                    {"branchRounds", "Max. rounds", "Maximum number of rounds of branch matching and pose fitting."}, 1,
                    1000)),
        onlyFor({"matched-branches"}, toggle<&Options::branches, &BranchOptions::motion>(
                                          {"branchMotion", "Allow vessel motion",
                                           "After the rigid fit, moves the branches to their matches while preserving "
                                           "branch lengths, and reports the displacement; the pose does not change."})),
        onlyFor({"graph-matching"},
                count<&Options::graph, &GraphOptions::hypotheses>(
                    {"graphHypotheses", "Hypotheses", "Maximum number of matched-branch sequences tested."}, 10, 2000)),
        onlyFor({"graph-matching"},
                number<&Options::graph, &GraphOptions::reachPx>(
                    {"graphReachPx", "Max. node distance",
                     "Maximum distance between a bifurcation or endpoint of the tree and its match in the image."},
                    {"px", 1.0, 2000.0, 0})),
        onlyFor({"graph-matching"}, number<&Options::graph, &GraphOptions::spreadWeight>(
                                        {"graphSpreadWeight", "Spread term",
                                         "Keeps the extent of the projected tree equal to that of the traced vessels; "
                                         "lower the weight if many branches are missing from the image."},
                                        {"", 0.0, 10.0, 2})),
    };
}

}   // namespace angiopose::core::option_fields
