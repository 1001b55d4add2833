#include "core/registration/registration_options.h"

#include "core/registration/method.h"

#include <algorithm>
#include <cmath>
#include <locale>
#include <sstream>

namespace core {
namespace {

using Options = RegistrationOptions;

template <auto Field>
double read(const Options& options)
{
    return static_cast<double>(options.*Field);
}

template <auto Field>
void write(Options& options, double value)
{
    using Value = std::remove_reference_t<decltype(options.*Field)>;
    if constexpr (std::is_integral_v<Value>) {
        options.*Field = static_cast<Value>(std::lround(value));
    } else {
        options.*Field = value;
    }
}

/// A number between two limits.
template <auto Field>
OptionField number(std::string_view key, std::string_view label, std::string_view unit, std::string_view help)
{
    OptionField field;
    field.key = key;
    field.label = label;
    field.unit = unit;
    field.help = help;
    field.read = read<Field>;
    field.write = write<Field>;
    return field;
}

OptionField within(OptionField field, double min, double max, int decimals)
{
    field.min = min;
    field.max = max;
    field.decimals = decimals;
    return field;
}

OptionField choice(OptionField field, std::vector<std::string_view> choices)
{
    field.max = static_cast<double>(choices.size() - 1);
    field.choices = std::move(choices);
    return field;
}

OptionField onlyFor(std::vector<std::string_view> methods, OptionField field)
{
    field.methods = std::move(methods);
    return field;
}

/// "0.2", not "0.200000", in any locale.
std::string plain(double number)
{
    std::ostringstream text;
    text.imbue(std::locale::classic());
    text << number;
    return text.str();
}

std::vector<OptionField> makeFields()
{
    const std::vector<std::string_view> ours{"angiopose"};
    const std::vector<std::string_view> seeds{"dynaweight", "iterative-pnp"};
    const std::vector<std::string_view> offOn{"off", "on"};
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
        onlyFor(seeds,
                choice(number<&Options::preset>("preset", "Prior", "",
                                                "How the pull towards the start pose is weighed against the image."),
                       {"seed_sum", "seed_mean", "seed_metric", "seed_noprior"})),
        onlyFor(seeds, within(number<&Options::priorWeight>("priorWeight", "Prior weight", "",
                                                            "Strength of the pull towards the start pose."),
                              0.0, 1e6, 2)),
        onlyFor({"dynaweight"}, choice(number<&Options::rotationFirst>("rotationFirst", "Rotation first", "",
                                                                       "Turns about the source before all else."),
                                       offOn)),
        onlyFor({"dynaweight"},
                choice(number<&Options::alternation>("alternation", "Alternation", "",
                                                     "Lets the auxiliary and the full problem take turns."),
                       offOn)),
        onlyFor(seeds, choice(number<&Options::index>("index", "Nearest points", "",
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
        onlyFor(ours, choice(number<&Options::search>("search", "Search", "",
                                                      "Looks for the pose around the start before refining it."),
                             offOn)),
        onlyFor(ours, within(number<&Options::searchRadiusMm>("searchRadiusMm", "Search radius", "mm",
                                                              "How far across the ray the search reaches."),
                             0.0, 200.0, 0)),
        onlyFor(ours, within(number<&Options::searchTiltDeg>("searchTiltDeg", "Search tilt", "°",
                                                             "How far the search reaches in LAO/RAO and CRA/CAU."),
                             0.0, 45.0, 1)),
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
        within(number<&Options::threads>("threads", "Threads", "", "Processor threads; never changes the result."), 1,
               64, 0),
    };
}

}   // namespace

const std::vector<OptionField>& optionFields()
{
    static const std::vector<OptionField> fields = makeFields();
    return fields;
}

std::string findProblem(const RegistrationOptions& options)
{
    if (findMethod(options.method) == nullptr) {
        std::string known;
        for (const MethodInfo& info : methodInfos()) {
            known += (known.empty() ? "" : ", ") + std::string(info.id);
        }
        return "There is no method '" + options.method + "'. Choose one of: " + known + ".";
    }
    for (const OptionField& field : optionFields()) {
        const double value = field.read(options);
        if (!(value >= field.min && value <= field.max)) {
            return "The option " + std::string(field.key) + " is out of range. Give a number from " + plain(field.min) +
                   " to " + plain(field.max) + ".";
        }
    }
    return {};
}

}   // namespace core
