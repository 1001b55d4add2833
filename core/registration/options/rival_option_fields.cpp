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
                             {"preset", "Prior", "How the pull towards the start pose is weighed against the image."},
                             {"seed_sum", "seed_mean", "seed_metric", "seed_noprior"})),
        onlyFor(kernels, number<&Options::seed, &SeedOptions::priorWeight>(
                             {"priorWeight", "Prior weight", "Strength of the pull towards the start pose."},
                             {"", 0.0, 1e6, 2})),
        onlyFor(turning, toggle<&Options::seed, &SeedOptions::rotationFirst>(
                             {"rotationFirst", "Rotation first", "Turns about the source before all else."})),
        onlyFor({"dynaweight"},
                toggle<&Options::seed, &SeedOptions::alternation>(
                    {"alternation", "Alternation", "Lets the auxiliary and the full problem take turns."})),
        onlyFor(pointBased, choice<&Options::seed, &SeedOptions::index>(
                                {"index", "Nearest points",
                                 "How they are found: the tree and the grid are exact, the map "
                                 "is right to within three pixels."},
                                {"kd-tree", "grid", "map"})),
        onlyFor(seeds, choice<&Options::seed, &SeedOptions::startScale>(
                           {"startScale", "Start scale",
                            "Kernel width at first: the largest distance, or its square "
                            "as the paper prints it."},
                           {"largest", "largest_squared"})),
        onlyFor(seeds, choice<&Options::seed, &SeedOptions::decay>(
                           {"decay", "Kernel decay",
                            "Narrows the kernel after five steps, or once no further point "
                            "comes within its reach."},
                           {"halving", "stagnation"})),
    };
}

std::vector<OptionField> alternatingFields()
{
    return {
        onlyFor(kernels, choice<&Options::seed, &SeedOptions::neighbors>(
                             {"neighbours", "Neighbours",
                              "Image points that pull each tree point: the nearest, the "
                              "five nearest, or all within three kernel widths."},
                             {"closest", "five", "radius"})),
        onlyFor(icps, toggle<&Options::icp, &IcpOptions::alternate>(
                          {"alternate", "Alternating search", "Lets the auxiliary points and all points take turns."})),
        onlyFor(alternating, choice<&Options::seed, &SeedOptions::auxiliary>(
                                 {"auxiliary", "Auxiliary points",
                                  "Chosen branches (nodes where none is chosen), nodes, the widest "
                                  "branches up to a third of the length, or random points."},
                                 {"chosen", "nodes", "main_branches", "random"})),
        onlyFor(alternating,
                count<&Options::seed, &SeedOptions::auxiliaryCount>(
                    {"auxiliaryCount", "Random points", "How many, where the auxiliary points are random."}, 4, 2000)),
    };
}

std::vector<OptionField> icpFields()
{
    return {
        onlyFor(icps, count<&Options::icp, &IcpOptions::iterations>(
                          {"icpIterations", "ICP iterations at most", "Matching and solving end after so many rounds."},
                          1, 1000)),
        onlyFor({"dt-icp"}, number<&Options::icp, &IcpOptions::huberPx>(
                                {"huberPx", "Huber distance", "Distance from which a point's pull stops growing."},
                                {"px", 0.5, 100.0, 1})),
        onlyFor({"dt-icp"},
                choice<&Options::icp, &IcpOptions::solver>({"icpSolver", "Solver",
                                                            "Damped steps on the Huber loss with fresh matches, or "
                                                            "L-BFGS on the squared distances."},
                                                           {"lm", "lbfgs"})),
        onlyFor({"dt-icp"},
                choice<&Options::icp, &IcpOptions::model>({"icpModel", "Transformation",
                                                           "Rigid only, or an affine stage after it, of which the "
                                                           "rigid part is kept if it fits better."},
                                                          {"rigid", "affine"})),
    };
}

std::vector<OptionField> nicpFields()
{
    return {
        onlyFor({"nicp"}, choice<&Options::nicp, &NicpOptions::image>(
                              {"nicpImage", "Attracted by",
                               "The traced vessels, or the brightness of the image at each "
                               "vessel's own width."},
                              {"traced_vessels", "image"})),
        onlyFor(nicps, choice<&Options::nicp, &NicpOptions::step>({"nicpStep", "Step",
                                                                   "Turns and shifts in balance, or raw radians beside "
                                                                   "millimetres, which hardly shifts."},
                                                                  {"metric", "literal"})),
        onlyFor(nicps, toggle<&Options::nicp, &NicpOptions::prior>(
                           {"nicpPrior", "Pull to the start", "Adds the prior chosen above to the attraction."})),
        onlyFor(nicps, number<&Options::nicp, &NicpOptions::startScalePx>(
                           {"nicpStartScalePx", "First kernel width", "Reach of the attraction at first."},
                           {"px", 1.0, 200.0, 1})),
        onlyFor(nicps, number<&Options::nicp, &NicpOptions::finalScalePx>(
                           {"nicpFinalScalePx", "Last kernel width", "Reach of the attraction in the end."},
                           {"px", 0.1, 50.0, 1})),
        onlyFor(nicps, count<&Options::nicp, &NicpOptions::iterations>(
                           {"nicpIterations", "Steps per width", "Gradient steps at each of the three widths at most."},
                           1, 2000)),
    };
}

std::vector<OptionField> imageFields()
{
    return {
        onlyFor({"rgbr"},
                number<&Options::rgbr, &RgbrOptions::reachMm>({"rgbrReachMm", "First reach",
                                                               "How far along the vessel walls' normals edges are "
                                                               "sought at first."},
                                                              {"mm", 1.0, 50.0, 1})),
        onlyFor({"rgbr"},
                count<&Options::rgbr, &RgbrOptions::hypotheses>(
                    {"rgbrHypotheses", "Hypotheses", "Poses from three random correspondences per round."}, 10, 5000)),
        onlyFor(
            {"rgbr"},
            count<&Options::rgbr, &RgbrOptions::rounds>(
                {"rgbrRounds", "Rounds at most", "Matching and choosing a pose end after so many rounds."}, 1, 200)),
        onlyFor({"automask"},
                number<&Options::automask, &AutoMaskOptions::sample>({"automaskSample", "Pixels compared",
                                                                      "Share of the mask that the rank correlation is "
                                                                      "taken over; at least 2000 pixels."},
                                                                     {"%", 0.5, 100.0, 1})),
        onlyFor({"automask"},
                number<&Options::automask, &AutoMaskOptions::marginPx>({"automaskMarginPx", "Mask margin",
                                                                        "How far the mask reaches beyond the projected "
                                                                        "vessels."},
                                                                       {"px", 1.0, 100.0, 0})),
        onlyFor({"automask"},
                count<&Options::automask, &AutoMaskOptions::evaluations>(
                    {"automaskEvaluations", "Evaluations at most", "Radiographs computed at most."}, 10, 20000)),
        onlyFor({"gradient-matching"},
                number<&Options::gradient, &GradientOptions::scalePx>(
                    {"gradientScalePx", "Edge scale", "Smoothing under the gradients of the image."},
                    {"px", 0.5, 20.0, 1})),
        onlyFor({"gradient-matching"},
                count<&Options::gradient, &GradientOptions::powellRounds>(
                    {"powellRounds", "Rounds at most", "Line searches along all six directions."}, 1, 200)),
    };
}

std::vector<OptionField> globalFields()
{
    return {
        onlyFor({"ogmm"}, number<&Options::ogmm, &OgmmOptions::startScalePx>(
                              {"ogmmStartScalePx", "First kernel width", "Width of the mixtures' Gaussians at first."},
                              {"px", 0.5, 200.0, 1})),
        onlyFor({"ogmm"}, number<&Options::ogmm, &OgmmOptions::finalScalePx>(
                              {"ogmmFinalScalePx", "Last kernel width", "Width of the mixtures' Gaussians in the end."},
                              {"px", 0.1, 50.0, 1})),
        onlyFor({"ogmm"}, number<&Options::ogmm, &OgmmOptions::orientation>(
                              {"ogmmOrientation", "Direction kernel", "How alike directions must be; small is strict."},
                              {"", 0.05, 10.0, 2})),
        onlyFor({"ogmm"},
                number<&Options::ogmm, &OgmmOptions::selfWeight>({"ogmmSelfWeight", "Self term",
                                                                  "Keeps the projected tree from shrinking; lower it "
                                                                  "where many branches are missing from the image."},
                                                                 {"", 0.0, 10.0, 2})),
        onlyFor({"evolution"},
                choice<&Options::evolution, &EvolutionOptions::strategy>({"evolutionStrategy", "Strategy",
                                                                          "Covariance matrix adaptation, or one parent "
                                                                          "and one child at a time."},
                                                                         {"cma-es", "one_plus_one"})),
        onlyFor({"evolution"}, count<&Options::evolution, &EvolutionOptions::population>(
                                   {"evolutionPopulation", "Population", "Poses tried per generation."}, 4, 500)),
        onlyFor({"evolution"}, count<&Options::evolution, &EvolutionOptions::evaluations>(
                                   {"evolutionEvaluations", "Evaluations at most", "Poses tried in all."}, 10, 100000)),
        onlyFor({"particle"},
                choice<&Options::particle, &ParticleOptions::search>({"particleSearch", "Search",
                                                                      "Annealed particles around the start, or a walk "
                                                                      "over the out-of-plane angles."},
                                                                     {"particles", "out_of_plane"})),
        onlyFor({"particle"}, count<&Options::particle, &ParticleOptions::count>(
                                  {"particles", "Particles", "Poses kept per round."}, 10, 10000)),
        onlyFor({"particle"}, count<&Options::particle, &ParticleOptions::rounds>(
                                  {"particleRounds", "Rounds", "The spread narrows by a quarter in each."}, 1, 50)),
    };
}

std::vector<OptionField> flowFields()
{
    return {
        onlyFor({"cvo"}, number<&Options::cvo, &CvoOptions::startScalePx>(
                             {"cvoStartScalePx", "First kernel width", "Reach of the attraction at first."},
                             {"px", 0.5, 200.0, 1})),
        onlyFor({"cvo"}, number<&Options::cvo, &CvoOptions::finalScalePx>(
                             {"cvoFinalScalePx", "Last kernel width", "Reach of the attraction in the end."},
                             {"px", 0.1, 50.0, 1})),
        onlyFor({"cvo"}, number<&Options::cvo, &CvoOptions::decay>(
                             {"cvoDecay", "Kernel decay",
                              "Factor by which the kernel narrows with each step after the first thirty."},
                             {"", 0.5, 0.999, 3})),
        onlyFor({"cvo"},
                count<&Options::cvo, &CvoOptions::iterations>(
                    {"cvoIterations", "Flow steps at most", "Steps along the flow, at all widths together."}, 1, 5000)),
        onlyFor({"cvo"}, toggle<&Options::cvo, &CvoOptions::directions>(
                             {"cvoDirections", "Directions count",
                              "Points attract each other the more, the more alike the vessels run there."})),
    };
}

std::vector<OptionField> graphFields()
{
    return {
        onlyFor({"matched-branches"},
                number<&Options::branches, &BranchOptions::reachPx>(
                    {"branchReachPx", "First reach in the image",
                     "How far branches and the traced vessels that show them may lie apart at first."},
                    {"px", 5.0, 500.0, 1})),
        onlyFor({"matched-branches"},
                count<&Options::branches, &BranchOptions::rounds>(
                    {"branchRounds", "Rounds at most", "Matching branches and fitting the pose end after so many."}, 1,
                    1000)),
        onlyFor({"matched-branches"},
                toggle<&Options::branches, &BranchOptions::motion>(
                    {"branchMotion", "Let vessels move",
                     "Moves the branches onto their partners after the rigid fit, lengths kept, and tells how far; the "
                     "pose stays."})),
        onlyFor({"graph-matching"},
                count<&Options::graph, &GraphOptions::hypotheses>(
                    {"graphHypotheses", "Hypotheses", "Sequences of matched branches tried at most."}, 10, 2000)),
        onlyFor({"graph-matching"},
                number<&Options::graph, &GraphOptions::reachPx>(
                    {"graphReachPx", "Reach of the roots",
                     "How far a bifurcation or end of the tree and one of the image may lie apart to be the same."},
                    {"px", 1.0, 2000.0, 0})),
        onlyFor({"graph-matching"},
                number<&Options::graph, &GraphOptions::spreadWeight>(
                    {"graphSpreadWeight", "Spread term",
                     "Keeps the projected tree as wide as the traced vessels; lower it where many branches are missing "
                     "from the image."},
                    {"", 0.0, 10.0, 2})),
    };
}

}   // namespace angiopose::core::option_fields
