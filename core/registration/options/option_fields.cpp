#include "core/registration/options/option_field_makers.h"

#include <algorithm>
#include <array>

namespace angiopose::core {
namespace {

using namespace option_fields;
using MethodIds = std::vector<std::string_view>;

const MethodIds ours{"angiopose"};
const MethodIds wires{"wire"};
const MethodIds seeds{"dynaweight", "iterative-pnp"};
const MethodIds nicps{"nicp", "nicp-alternating"};
const MethodIds icps{"dt-icp", "assembled-icp"};
const MethodIds kernels{"dynaweight", "iterative-pnp", "nicp", "nicp-alternating"};
const MethodIds pointBased{"dynaweight", "iterative-pnp", "nicp", "nicp-alternating", "dt-icp", "assembled-icp"};
const MethodIds alternating{"dynaweight", "nicp-alternating", "dt-icp", "assembled-icp"};
const MethodIds turning{"dynaweight", "nicp-alternating", "dt-icp"};
const MethodIds chance{"dynaweight", "nicp-alternating", "dt-icp",    "assembled-icp",
                       "rgbr",       "automask",         "evolution", "particle"};
const std::array<std::string_view, 2> offOn{"off", "on"};

/// What every method or several read.
std::vector<OptionField> commonFields()
{
    return {
        number<&Options::pointSpacingMm>({"pointSpacingMm", "Tree point spacing",
                                          "Distance between the tree points that are matched; smaller is slower."},
                                         {"mm", 0.2, 5.0, 2}),
        number<&Options::targetSpacingPx>(
            {"targetSpacingPx", "Image point spacing", "Distance between the points of the traced vessels."},
            {"px", 0.25, 5.0, 2}),
        toggle<&Options::resample>(
            {"resample", "Even spacing", "Spreads the points evenly before matching; off takes them as they are."}),
        count<&Options::maxIterations>(
            {"maxIterations", "Iterations at most", "The refinement ends after so many steps."}, 1, 1000),
        number<&Options::finalScalePx>(
            {"finalScalePx", "Final scale",
             "Distance beyond which a point hardly counts in the end; the noise of the image may widen it."},
            {"px", 0.1, 20.0, 2}),
    };
}

/// The seed's methods, and what those built like them share.
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

/// Matching and the alternating search.
std::vector<OptionField> alternatingFields()
{
    return {
        onlyFor(kernels, choice<&Options::seed, &SeedOptions::neighbours>(
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

/// Our own solver.
std::vector<OptionField> solverFields()
{
    return {
        onlyFor(ours, toggle<&Options::angiopose, &AngioPoseOptions::search>(
                          {"search", "Search", "Looks for the pose around the start before refining it."})),
        onlyFor(ours, number<&Options::angiopose, &AngioPoseOptions::searchRadiusMm>(
                          {"searchRadiusMm", "Search radius", "How far across the ray the search reaches."},
                          {"mm", 0.0, 200.0, 0})),
        onlyFor(ours, number<&Options::angiopose, &AngioPoseOptions::searchTiltDeg>(
                          {"searchTiltDeg", "Search tilt", "How far the search reaches in LAO/RAO and CRA/CAU."},
                          {"°", 0.0, 90.0, 1})),
        onlyFor(ours, number<&Options::angiopose, &AngioPoseOptions::searchRollDeg>(
                          {"searchRollDeg", "Search roll", "How far the search turns the vessels in the image."},
                          {"°", 0.0, 180.0, 1})),
        onlyFor(ours, number<&Options::angiopose, &AngioPoseOptions::priorRotationDeg>(
                          {"priorRotationDeg", "Start rotation ±",
                           "Standard deviation of the start pose's angles; holds what the image cannot tell."},
                          {"°", 0.1, 90.0, 1})),
        onlyFor(ours, number<&Options::angiopose, &AngioPoseOptions::priorLateralMm>(
                          {"priorLateralMm", "Start shift ±", "Standard deviation of the start pose across the ray."},
                          {"mm", 0.1, 500.0, 1})),
        onlyFor(ours, number<&Options::angiopose, &AngioPoseOptions::priorDepthMm>(
                          {"priorDepthMm", "Start depth ±", "Standard deviation of the start pose along the ray."},
                          {"mm", 0.1, 500.0, 1})),
        onlyFor(ours, number<&Options::angiopose, &AngioPoseOptions::auxiliaryWeight>(
                          {"auxiliaryWeight", "Weight of chosen branches",
                           "How much the branches chosen as auxiliary count against the fit of all; 1: they are not "
                           "fitted apart."},
                          {"", 1.0, 1000.0, 1})),
    };
}

/// A wire or catheter alone.
std::vector<OptionField> wireFields()
{
    return {
        onlyFor(wires,
                number<&Options::wire, &WireOptions::rotationDeg>(
                    {"wireRotationDeg", "Last pose ±, rotation", "Standard deviation of the last full pose's angles."},
                    {"°", 0.1, 30.0, 1})),
        onlyFor(wires,
                number<&Options::wire, &WireOptions::lateralMm>(
                    {"wireLateralMm", "Last pose ±, shift", "Standard deviation of the last full pose across the ray."},
                    {"mm", 0.1, 100.0, 1})),
        onlyFor(wires,
                number<&Options::wire, &WireOptions::depthMm>(
                    {"wireDepthMm", "Last pose ±, depth", "Standard deviation of the last full pose along the ray."},
                    {"mm", 0.1, 200.0, 1})),
        onlyFor(wires, number<&Options::wire, &WireOptions::offAxisMm>(
                           {"offAxisMm", "Off the axis ±",
                            "Standard deviation of the wire from the vessel's axis, beside what the vessel's width "
                            "lets it."},
                           {"mm", 0.2, 10.0, 1})),
        onlyFor(wires, count<&Options::wire, &WireOptions::way>(
                           {"wireWay", "Way taken", "1 is the most likely way, 2 the next one, and so on."}, 1, 9)),
    };
}

/// What is known of the camera.
std::vector<OptionField> geometryFields()
{
    return {
        choice<&Options::geometry, &GeometryOptions::spread>(
            {"geometryErrors", "Errors of the geometry",
             "Whether focal length and principal point may be off by what is usual where they come from, by what is "
             "given below, or not at all."},
            {"by_origin", "given", "none"}),
        number<&Options::geometry, &GeometryOptions::focalPercent>(
            {"focalErrorPercent", "Focal length ±", "Standard deviation of the focal length where it is given."},
            {"%", 0.0, 50.0, 1}),
        number<&Options::geometry, &GeometryOptions::principalPx>(
            {"principalErrorPx", "Principal point ±",
             "Standard deviation of each coordinate of the principal point where it is given."},
            {"px", 0.0, 500.0, 1}),
        toggle<&Options::geometry, &GeometryOptions::estimate>(
            {"estimateGeometry", "Estimate the geometry",
             "Where the images clearly contradict focal length or principal point, takes over those that they show and "
             "registers again."}),
        onlyFor(ours, toggle<&Options::geometry, &GeometryOptions::otherFrames>(
                          {"otherFrames", "Mirrored and turned images",
                           "Where a fit is in doubt, tells whether the image looks mirrored or turned."})),
        choice<&Options::bending>({"deformable", "Bent vessels",
                                   "Whether the vessels are bent onto the image after the rigid registration: never, "
                                   "where the fit looks as if they were bent (angiopose, nothing locked), or always."},
                                  {"never", "auto", "always"}),
    };
}

/// Iterated closest points.
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

/// Gradient ascent on kernels.
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

/// Methods that read the image.
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

/// Mixtures and searches.
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

/// Flow of a correlation.
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

/// Branches of tree and image as graphs.
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

/// Chance.
std::vector<OptionField> closingFields()
{
    return {
        onlyFor(chance, count<&Options::randomSeed>(
                            {"randomSeed", "Random seed", "Another number draws other lots; the same repeats them."}, 1,
                            1000000)),
    };
}

}   // namespace

const std::vector<OptionField>& optionFields()
{
    static const std::vector<OptionField> fields = [] {
        std::vector<OptionField> all;
        for (const auto make :
             {commonFields, seedFields, alternatingFields, solverFields, geometryFields, icpFields, nicpFields,
              imageFields, globalFields, flowFields, graphFields, wireFields, closingFields}) {
            const std::vector<OptionField> group = make();
            all.insert(all.end(), group.begin(), group.end());
        }
        return all;
    }();
    return fields;
}

const OptionField* findOption(std::string_view key)
{
    const auto found = std::ranges::find(optionFields(), key, &OptionField::key);
    return found == optionFields().end() ? nullptr : &*found;
}

bool isFor(const OptionField& field, std::string_view method)
{
    return field.methods.empty() || std::ranges::find(field.methods, method) != field.methods.end();
}

std::span<const std::string_view> namesOf(const OptionField& field)
{
    if (std::holds_alternative<SwitchOption>(field.type)) {
        return offOn;
    }
    const auto* choice = std::get_if<ChoiceOption>(&field.type);
    return choice == nullptr ? std::span<const std::string_view>() : choice->names;
}

std::string_view nameOf(const OptionField& field, const OptionValue& value)
{
    const auto* number = std::get_if<std::size_t>(&value);
    const auto* isOn = std::get_if<bool>(&value);
    const auto names = namesOf(field);
    const std::size_t index = number != nullptr ? *number : isOn != nullptr && *isOn ? 1 : 0;
    return index < names.size() ? names[index] : std::string_view();
}

OptionRange rangeOf(const OptionField& field)
{
    if (const auto* number = std::get_if<NumberOption>(&field.type)) {
        return {number->min, number->max};
    }
    return {0.0, static_cast<double>(namesOf(field).size() - 1)};
}

std::optional<OptionValue> valueFrom(const OptionField& field, double number)
{
    const OptionRange range = rangeOf(field);
    if (!(number >= range.min && number <= range.max)) {
        return {};
    }
    if (std::holds_alternative<NumberOption>(field.type)) {
        return number;
    }
    if (number != std::floor(number)) {
        return {};
    }
    const auto index = static_cast<std::size_t>(number);
    return std::holds_alternative<SwitchOption>(field.type) ? OptionValue(index == 1) : OptionValue(index);
}

std::optional<OptionValue> valueFrom(const OptionField& field, std::string_view name)
{
    const auto names = namesOf(field);
    const auto found = std::ranges::find(names, name);
    return found == names.end() ? std::nullopt : valueFrom(field, static_cast<double>(found - names.begin()));
}

bool isInRange(const OptionField& field, const RegistrationOptions& options)
{
    const OptionValue value = field.read(options);
    if (const auto* number = std::get_if<double>(&value)) {
        return valueFrom(field, *number).has_value();
    }
    return !nameOf(field, value).empty();
}

}   // namespace angiopose::core