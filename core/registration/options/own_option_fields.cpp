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
        choice<&Options::deformation>(
            {"deformable", "Bent vessels",
             "Whether the vessels are bent onto the image after the rigid registration: never, "
             "where the fit looks as if they were bent (angiopose, nothing locked), or always."},
            {"never", "auto", "always"}),
    };
}

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

std::vector<OptionField> closingFields()
{
    return {
        onlyFor(chance, count<&Options::randomSeed>(
                            {"randomSeed", "Random seed", "Another number draws other lots; the same repeats them."}, 1,
                            1000000)),
    };
}

}   // namespace angiopose::core::option_fields
