#include "core/registration/options/option_field_makers.h"
#include "core/registration/options/option_groups.h"

namespace angiopose::core::option_fields {
namespace {

using MethodIds = std::vector<std::string_view>;

const MethodIds ours{"angiopose"};
const MethodIds wires{"wire"};
const MethodIds chance{"dynaweight", "nicp-alternating", "dt-icp",    "assembled-icp",
                       "rgbr",       "automask",         "evolution", "particle"};

}   // namespace

std::vector<OptionField> commonFields()
{
    return {
        number<&Options::pointSpacingMm>({"pointSpacingMm", "Tree point spacing",
                                          "Spacing of the tree points used for matching; smaller values are slower."},
                                         {"mm", 0.2, 5.0, 2}),
        number<&Options::targetSpacingPx>(
            {"targetSpacingPx", "Image point spacing", "Spacing of the points on the traced vessels."},
            {"px", 0.25, 5.0, 2}),
        toggle<&Options::resample>(
            {"resample", "Even spacing",
             "Resamples the points at even spacing before matching; if off, the points are used unchanged."}),
        count<&Options::maxIterations>({"maxIterations", "Max. iterations", "Maximum number of refinement steps."}, 1,
                                       1000),
        number<&Options::finalScalePx>(
            {"finalScalePx", "Final scale",
             "Distance beyond which a point has little weight in the final stage; image noise can increase it."},
            {"px", 0.1, 20.0, 2}),
    };
}

std::vector<OptionField> solverFields()
{
    return {
        onlyFor(ours,
                toggle<&Options::angiopose, &AngioPoseOptions::search>(
                    {"search", "Search", "Searches the neighborhood of the initial pose before the refinement."})),
        onlyFor(ours, number<&Options::angiopose, &AngioPoseOptions::searchRadiusMm>(
                          {"searchRadiusMm", "Search radius", "Search range perpendicular to the ray."},
                          {"mm", 0.0, 200.0, 0})),
        onlyFor(ours,
                number<&Options::angiopose, &AngioPoseOptions::searchTiltDeg>(
                    {"searchTiltDeg", "Search tilt", "Search range in LAO/RAO and CRA/CAU."}, {"°", 0.0, 90.0, 1})),
        onlyFor(ours,
                number<&Options::angiopose, &AngioPoseOptions::searchRollDeg>(
                    {"searchRollDeg", "Search roll", "Search range of the in-plane rotation."}, {"°", 0.0, 180.0, 1})),
        onlyFor(ours, number<&Options::angiopose, &AngioPoseOptions::priorRotationDeg>(
                          {"priorRotationDeg", "Initial rotation ±",
                           "Standard deviation of the initial pose angles; constrains the components that the image "
                           "cannot determine."},
                          {"°", 0.1, 90.0, 1})),
        onlyFor(ours, number<&Options::angiopose, &AngioPoseOptions::priorLateralMm>(
                          {"priorLateralMm", "Initial shift ±",
                           "Standard deviation of the initial pose perpendicular to the ray."},
                          {"mm", 0.1, 500.0, 1})),
        onlyFor(ours, number<&Options::angiopose, &AngioPoseOptions::priorDepthMm>(
                          {"priorDepthMm", "Initial depth ±", "Standard deviation of the initial pose along the ray."},
                          {"mm", 0.1, 500.0, 1})),
        onlyFor(ours, number<&Options::angiopose, &AngioPoseOptions::auxiliaryWeight>(
                          {"auxiliaryWeight", "Auxiliary branch weight",
                           "Weight of the auxiliary branches relative to the fit of all branches; 1: no separate fit."},
                          {"", 1.0, 1000.0, 1})),
    };
}

std::vector<OptionField> geometryFields()
{
    return {
        choice<&Options::geometry, &GeometryOptions::spread>(
            {"geometryErrors", "Geometry uncertainty",
             "Uncertainty of focal length and principal point: typical for their source, as given below, or none."},
            {"by_origin", "given", "none"}),
        number<&Options::geometry, &GeometryOptions::focalPercent>(
            {"focalErrorPercent", "Focal length ±", "Standard deviation of the focal length, if specified."},
            {"%", 0.0, 50.0, 1}),
        number<&Options::geometry, &GeometryOptions::principalPx>(
            {"principalErrorPx", "Principal point ±",
             "Standard deviation of each principal-point coordinate, if specified."},
            {"px", 0.0, 500.0, 1}),
        toggle<&Options::geometry, &GeometryOptions::estimate>(
            {"estimateGeometry", "Estimate geometry",
             "If the images clearly contradict the focal length or principal point, adopts the values they indicate "
             "and registers again."}),
        onlyFor(ours, toggle<&Options::geometry, &GeometryOptions::checkOrientation>(
                          {"otherFrames", "Mirrored or rotated images",
                           "If confidence is low, reports whether the image appears mirrored or rotated."})),
        choice<&Options::deformation>(
            {"deformable", "Deformation",
             "Deforms the vessels to match the image after the rigid registration: never; automatically, if the fit "
             "suggests a deformation (method angiopose, nothing locked); or always."},
            {"never", "auto", "always"}),
    };
}

std::vector<OptionField> wireFields()
{
    return {
        onlyFor(wires,
                number<&Options::wire, &WireOptions::rotationDeg>(
                    {"wireRotationDeg", "Last pose ± (rotation)", "Standard deviation of the last full pose's angles."},
                    {"°", 0.1, 30.0, 1})),
        onlyFor(wires, number<&Options::wire, &WireOptions::lateralMm>(
                           {"wireLateralMm", "Last pose ± (shift)",
                            "Standard deviation of the last full pose perpendicular to the ray."},
                           {"mm", 0.1, 100.0, 1})),
        onlyFor(wires,
                number<&Options::wire, &WireOptions::depthMm>(
                    {"wireDepthMm", "Last pose ± (depth)", "Standard deviation of the last full pose along the ray."},
                    {"mm", 0.1, 200.0, 1})),
        onlyFor(wires, number<&Options::wire, &WireOptions::offAxisMm>(
                           {"offAxisMm", "Off-axis ±",
                            "Standard deviation of the guidewire from the vessel axis, in addition to its free play "
                            "within the lumen."},
                           {"mm", 0.2, 10.0, 1})),
        onlyFor(wires,
                count<&Options::wire, &WireOptions::way>(
                    {"wireWay", "Path rank", "Rank of the path by probability: 1 is the most probable path."}, 1, 9)),
    };
}

std::vector<OptionField> randomSeedFields()
{
    return {
        onlyFor(chance,
                count<&Options::randomSeed>(
                    {"randomSeed", "Random seed", "Seed of the random numbers; the same seed reproduces the result."},
                    1, 1000000)),
    };
}

}   // namespace angiopose::core::option_fields
