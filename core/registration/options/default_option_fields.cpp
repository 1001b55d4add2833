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
        number<&Options::pointSpacingMm>(
            {"pointSpacingMm", "Tree point spacing",
             "Spacing of the tree points used for matching; a smaller spacing takes longer to compute."},
            {"mm", 0.2, 5.0, 2}),
        number<&Options::targetSpacingPx>(
            {"targetSpacingPx", "Image point spacing", "Spacing of the points on the traced vessels."},
            {"px", 0.25, 5.0, 2}),
        toggle<&Options::resample>(
            {"resample", "Even spacing",
             "Resamples the points at even spacing before matching; if off, the points are used unchanged."}),
        count<&Options::maxIterations>({"maxIterations", "Max. iterations", "Maximum number of refinement steps."}, 1,
                                       1000),
        number<&Options::finalScalePx>({"finalScalePx", "Final scale",
                                        "Distance beyond which a point has little weight in the final stage; image "
                                        "noise can increase this distance."},
                                       {"px", 0.1, 20.0, 2}),
    };
}

std::vector<OptionField> solverFields()
{
    return {
        onlyFor(ours, toggle<&Options::angiopose, &AngioPoseOptions::search>(
                          {"search", "Search", "Searches the neighborhood of the initial pose before refinement."})),
        onlyFor(ours,
                number<&Options::angiopose, &AngioPoseOptions::searchRadiusMm>(
                    {"searchRadiusMm", "Search radius", "Search range of the in-plane shift."}, {"mm", 0.0, 200.0, 0})),
        onlyFor(ours, number<&Options::angiopose, &AngioPoseOptions::searchTiltDeg>(
                          {"searchTiltDeg", "Tilt search range", "Search range of the LAO/RAO and CRA/CAU angles."},
                          {"°", 0.0, 90.0, 1})),
        onlyFor(ours, number<&Options::angiopose, &AngioPoseOptions::searchRollDeg>(
                          {"searchRollDeg", "Roll search range", "Search range of the in-plane rotation."},
                          {"°", 0.0, 180.0, 1})),
        onlyFor(ours, number<&Options::angiopose, &AngioPoseOptions::priorRotationDeg>(
                          {"priorRotationDeg", "Initial rotation ±",
                           "Standard deviation of the angles of the initial pose; constrains the components that the "
                           "image cannot determine."},
                          {"°", 0.1, 90.0, 1})),
        onlyFor(ours, number<&Options::angiopose, &AngioPoseOptions::priorLateralMm>(
                          {"priorLateralMm", "Initial shift ±",
                           "Standard deviation of the in-plane position of the initial pose."},
                          {"mm", 0.1, 500.0, 1})),
        onlyFor(ours, number<&Options::angiopose, &AngioPoseOptions::priorDepthMm>(
                          {"priorDepthMm", "Initial depth ±", "Standard deviation of the depth of the initial pose."},
                          {"mm", 0.1, 500.0, 1})),
        onlyFor(ours, number<&Options::angiopose, &AngioPoseOptions::auxiliaryWeight>(
                          {"auxiliaryWeight", "Auxiliary branch weight",
                           "Weight of the auxiliary branches relative to the fit of all branches; with a weight of 1, "
                           "they are not fitted separately."},
                          {"", 1.0, 1000.0, 1})),
    };
}

std::vector<OptionField> geometryFields()
{
    return {
        choice<&Options::geometry, &GeometryOptions::spread>(
            {"geometryErrors", "Geometry uncertainty",
             "Uncertainty of the focal length and the principal point: typical of their source, as specified below, or "
             "none."},
            {"by_origin", "given", "none"}),
        number<&Options::geometry, &GeometryOptions::focalPercent>(
            {"focalErrorPercent", "Focal length ±",
             "Standard deviation of the focal length; applies if the geometry uncertainty is set to “given”."},
            {"%", 0.0, 50.0, 1}),
        number<&Options::geometry, &GeometryOptions::principalPx>(
            {"principalErrorPx", "Principal point ±",
             "Standard deviation of each principal-point coordinate; applies if the geometry uncertainty is set to "
             "“given”."},
            {"px", 0.0, 500.0, 1}),
        toggle<&Options::geometry, &GeometryOptions::estimate>(
            {"estimateGeometry", "Estimate geometry",
             "If the images clearly contradict the focal length or the principal point, adopts the values that best "
             "fit the images and registers again."}),
        onlyFor(ours, toggle<&Options::geometry, &GeometryOptions::checkOrientation>(
                          {"otherFrames", "Mirrored or rotated images",
                           "If confidence is low, reports whether the image appears mirrored or rotated."})),
        choice<&Options::deformation>(
            {"deformable", "Deformation",
             "Whether to deform the vessels to match the image after rigid registration: never; automatically, if the "
             "fit suggests a deformation (AngioPose method, no degrees of freedom locked); or always."},
            {"never", "auto", "always"}),
    };
}

std::vector<OptionField> wireFields()
{
    return {
        onlyFor(wires, number<&Options::wire, &WireOptions::rotationDeg>(
                           {"wireRotationDeg", "Last pose ± (rotation)",
                            "Standard deviation of the angles in the last full registration."},
                           {"°", 0.1, 30.0, 1})),
        onlyFor(wires, number<&Options::wire, &WireOptions::lateralMm>(
                           {"wireLateralMm", "Last pose ± (shift)",
                            "Standard deviation of the in-plane position in the last full registration."},
                           {"mm", 0.1, 100.0, 1})),
        onlyFor(wires, number<&Options::wire, &WireOptions::depthMm>(
                           {"wireDepthMm", "Last pose ± (depth)",
                            "Standard deviation of the depth in the last full registration."},
                           {"mm", 0.1, 200.0, 1})),
        onlyFor(wires, number<&Options::wire, &WireOptions::offAxisMm>(
                           {"offAxisMm", "Off-axis ±",
                            "Standard deviation of the distance of the guidewire from the centerline, in addition to "
                            "its free play within the lumen."},
                           {"mm", 0.2, 10.0, 1})),
        onlyFor(wires,
                count<&Options::wire, &WireOptions::way>(
                    {"wireWay", "Path rank", "Rank of the path by probability: 1 is the most probable path."}, 1, 9)),
    };
}

std::vector<OptionField> randomSeedFields()
{
    return {
        onlyFor(chance, count<&Options::randomSeed>(
                            {"randomSeed", "Random seed",
                             "Seed of the random number generator; the same seed reproduces the result."},
                            1, 1000000)),
    };
}

}   // namespace angiopose::core::option_fields
