#include "angiopose/registration.h"
#include "angiopose/deformation.h"
#include "app/python/read_only.h"
#include "app/python/work.h"

namespace angiopose::python {
namespace {

using OptionalImage = std::optional<Array<float>>;

RegistrationInput inputFrom(const VesselTree& tree, const Centerline2d& target, const ProjectionCamera& camera,
                            const Pose& initialCameraFromPatient, const std::vector<int>& excludedBranchIds,
                            const std::vector<int>& auxiliaryBranchIds, const OptionalImage& image, Polarity polarity,
                            const std::optional<Volume>& volume, const std::optional<Pose>& lockReference,
                            const std::optional<Eigen::Vector3d>& lockPivotInPatient)
{
    return {tree,
            target,
            camera,
            initialCameraFromPatient,
            excludedBranchIds,
            auxiliaryBranchIds,
            image ? imageOf(*image, "image") : Image(),
            polarity,
            volume,
            lockReference,
            lockPivotInPatient};
}

/// Getter that returns a copy of the field, so that arrays obtained from it stay valid when the field is assigned.
template <auto Field>
auto copied()
{
    return [](const RegistrationInput& input) { return input.*Field; };
}

void bindInput(py::module_& module)
{
    using Input = RegistrationInput;
    py::class_<Input>(module, "RegistrationInput",
                      "Input of one registration; the first four arguments define the problem.")
        .def(py::init(&inputFrom), py::arg("tree"), py::arg("target"), py::arg("camera"),
             py::arg("initialCameraFromPatient"), py::kw_only(), py::arg("excludedBranchIds") = std::vector<int>(),
             py::arg("auxiliaryBranchIds") = std::vector<int>(), py::arg("image") = py::none(),
             py::arg("polarity") = Polarity::VesselsDark, py::arg("volume") = py::none(),
             py::arg("lockReference") = py::none(), py::arg("lockPivotInPatient") = py::none(),
             "initialCameraFromPatient: (4, 4), the initial pose. image: (height, width), the frame that shows\nthe "
             "target, for methods that use it.")
        .def_property("tree", copied<&Input::tree>(), assign<&Input::tree>(), "the vessels; patient LPS mm")
        .def_property("target", copied<&Input::target>(), assign<&Input::target>(), "the vessels of the image, px")
        .def_readwrite("camera", &Input::camera, "its attributes can be set")
        .def_property("initialCameraFromPatient", asArray<&Input::initialCameraFromPatient>(),
                      assign<&Input::initialCameraFromPatient>(),
                      "(4, 4), patient LPS mm to camera mm: the initial pose")
        .def_property("excludedBranchIds", asTuple<&Input::excludedBranchIds>(), assign<&Input::excludedBranchIds>(),
                      "excluded branches")
        .def_property("auxiliaryBranchIds", asTuple<&Input::auxiliaryBranchIds>(), assign<&Input::auxiliaryBranchIds>(),
                      "branches that alternating methods solve first")
        .def_property(
            "image",
            [](const Input& input) {
                py::array_t<float> image({input.image.height, input.image.width}, input.image.pixels.data());
                image.attr("flags").attr("writeable") = false;
                return image;
            },
            [](Input& input, const OptionalImage& image) { input.image = image ? imageOf(*image, "image") : Image(); },
            "(height, width) float32, a read-only copy; (0, 0): none")
        .def_readwrite("polarity", &Input::polarity, "of `image`")
        .def_readwrite("volume", &Input::volume, "the CTA that shows the tree, or None")
        .def_property("lockReference", asArray<&Input::lockReference>(), assign<&Input::lockReference>(),
                      "(4, 4), reference pose of locked angles; None: the initial pose")
        .def_property("lockPivotInPatient", asArray<&Input::lockPivotInPatient>(), assign<&Input::lockPivotInPatient>(),
                      "(3,), point whose position locked shifts preserve; None: the centroid");
}

void bindMetrics(py::module_& module)
{
    py::enum_<StopReason>(module, "StopReason", "Why a registration ended.")
        .value("Converged", StopReason::Converged)
        .value("IterationLimit", StopReason::IterationLimit)
        .value("NoImprovement", StopReason::NoImprovement)
        .value("StoppedByUser", StopReason::StoppedByUser);

    py::class_<DistanceMetrics>(module, "DistanceMetrics",
                                "Closest-point distances over all tree points used; mm at the depth of the centroid.")
        .def_readonly("meanPx", &DistanceMetrics::meanPx, "mean, px")
        .def_readonly("medianPx", &DistanceMetrics::medianPx, "median, px")
        .def_readonly("p75Px", &DistanceMetrics::p75Px, "75th percentile, px")
        .def_readonly("p95Px", &DistanceMetrics::p95Px, "95th percentile, px")
        .def_readonly("meanMm", &DistanceMetrics::meanMm, "mean, mm")
        .def_readonly("medianMm", &DistanceMetrics::medianMm, "median, mm")
        .def_readonly("p75Mm", &DistanceMetrics::p75Mm, "75th percentile, mm")
        .def_readonly("p95Mm", &DistanceMetrics::p95Mm, "95th percentile, mm")
        .def_readonly("coverage", &DistanceMetrics::coverage, "share of image points within 3 px of the tree, 0...1")
        .def_readonly("reverseMeanPx", &DistanceMetrics::reverseMeanPx, "mean distance of image points to the tree")
        .def_readonly("reverseMeanMm", &DistanceMetrics::reverseMeanMm, "mean distance of image points to the tree, mm")
        .def("__repr__", [](const DistanceMetrics& metrics) {
            return py::str("<DistanceMetrics: median {:.3g} px, p95 {:.3g} px, coverage {:.0%}>")
                .format(metrics.medianPx, metrics.p95Px, metrics.coverage);
        });

    py::class_<PoseUncertainty>(
        module, "PoseUncertainty",
        "Covariance of a pose about centroidInPatient in camera axes. Order: rotation x, y, z (rad), shift x, y, "
        "z\n(mm). With c = cameraFromPatient @ centroid, (r, t) maps a camera point p to c + R(r) (p - c) + t.")
        .def_property_readonly("centroidInPatient", asArray<&PoseUncertainty::centroidInPatient>(),
                               "(3,), LPS mm, of the whole tree, weighted by length")
        .def_property_readonly("covariance", asArray<&PoseUncertainty::covariance>(), "(6, 6)")
        .def_property_readonly("rotationDeg", asArray<&PoseUncertainty::rotationDeg>(),
                               "(3,), 1-sigma about camera x, y, z")
        .def_readonly("inPlaneMm", &PoseUncertainty::inPlaneMm, "1-sigma, the larger lateral direction")
        .def_readonly("depthMm", &PoseUncertainty::depthMm, "1-sigma along the ray")
        .def_property_readonly(
            "observed", [](const PoseUncertainty& uncertainty) { return py::tuple(py::cast(uncertainty.observed)); },
            "6 flags; False: cannot be determined from the image")
        .def_property_readonly("weakestDirection", asArray<&PoseUncertainty::weakestDirection>(),
                               "(6,), unit vector; rotations scaled by the tree's extent in mm")
        .def("__repr__", [](const PoseUncertainty& uncertainty) {
            return py::str("<PoseUncertainty: in plane {:.3g} mm, depth {:.3g} mm>")
                .format(uncertainty.inPlaneMm, uncertainty.depthMm);
        });

    py::class_<BranchResidual>(module, "BranchResidual", "Agreement of one branch with the image.")
        .def_readonly("branchId", &BranchResidual::branchId, "id of the branch")
        .def_readonly("pointCount", &BranchResidual::pointCount, "number of its points")
        .def_readonly("medianPx", &BranchResidual::medianPx, "median distance to the image points")
        .def_readonly("p95Px", &BranchResidual::p95Px, "95th percentile of that distance")
        .def_readonly("agreement", &BranchResidual::agreement, "share of its points within 3 px, 0...1");

    py::class_<Hypothesis>(module, "Hypothesis", "Another pose that fits the image nearly as well.")
        .def_property_readonly("cameraFromPatient", asArray<&Hypothesis::cameraFromPatient>(),
                               "(4, 4), patient LPS mm to camera mm")
        .def_readonly("score", &Hypothesis::score, "0...1, higher is better");

    py::class_<WirePath>(module, "WirePath", "A possible path of a guidewire or catheter through the tree.")
        .def_property_readonly("branchIds", asTuple<&WirePath::branchIds>(),
                               "in order along the guidewire, whose tip lies in the last branch")
        .def_property_readonly("tipInPatient", asArray<&WirePath::tipInPatient>(),
                               "(3,), LPS mm, on the centerline of the branch")
        .def_readonly("probability", &WirePath::probability,
                      "0...1, among all paths considered and the possibility of none")
        .def_readonly("offAxisMm", &WirePath::offAxisMm,
                      "RMS distance of the guidewire from the branch centerlines in the image")
        .def_readonly("followedShare", &WirePath::followedShare,
                      "share of the guidewire length in the image that follows the path, 0...1")
        .def_property_readonly("cameraFromPatient", asArray<&WirePath::cameraFromPatient>(),
                               "(4, 4), patient LPS mm to camera mm");
}

void bindResults(py::module_& module)
{
    using Result = RegistrationResult;
    py::class_<Result>(module, "RegistrationResult", "A pose and its reliability.")
        .def_readonly("method", &Result::method, "empty if the pose was only evaluated")
        .def_property_readonly("cameraFromPatient", asArray<&Result::cameraFromPatient>(),
                               "(4, 4), patient LPS mm to camera mm")
        .def_readonly("stopReason", &Result::stopReason, "Converged if the pose was only evaluated")
        .def_readonly("iterations", &Result::iterations, "iterations of the solver")
        .def_readonly("metrics", &Result::metrics, "distances in px and mm")
        .def_readonly("uncertainty", &Result::uncertainty, "covariance of the pose")
        .def_property_readonly("branches", asTuple<&Result::branches>(), "branches used, in the tree's order")
        .def_property_readonly("alternatives", asTuple<&Result::alternatives>(),
                               "best first, without the result itself")
        .def_property_readonly("wirePaths", asTuple<&Result::wirePaths>(),
                               "for the method wire, most likely first; the pose is that of the first")
        .def_readonly("bent", &Result::deformed,
                      "BentVessels if a deformable registration was requested (option deformable), else None")
        .def_readonly("trustworthy", &Result::trustworthy,
                      "False: inspect the pose before use; `warnings` give the reasons")
        .def_readonly("probabilityWithin2Mm", &Result::probabilityWithin2Mm,
                      "probability that the overlay lies within 2 mm of the vessels, averaged over the tree, 0...1; "
                      "None if unknown: other methods, several views, poses that were only evaluated")
        .def_property_readonly("warnings", asTuple<&Result::warnings>(),
                               "why it is not reliable, then what a single view cannot determine")
        .def_readonly("totalMs", &Result::totalMs, "duration of the registration")
        .def("__repr__", [](const Result& result) {
            return "<RegistrationResult " + result.method + ": median " + std::to_string(result.metrics.medianPx) +
                   " px, " + (result.trustworthy ? "trustworthy>" : "not trustworthy>");
        });

    py::class_<MultiViewResult>(module, "MultiViewResult", "Result of registering one tree to several views.")
        .def_property_readonly("views", asTuple<&MultiViewResult::views>(),
                               "each evaluated at its joint pose, in the order given")
        .def_property_readonly(
            "corrections",
            [](const MultiViewResult& result) {
                py::list corrections;
                for (const Vector6d& correction : result.corrections) {
                    corrections.append(readOnlyArray(correction));
                }
                return py::tuple(corrections);
            },
            "(6,) each: rotation (rad) and shift (mm) of a view's geometry relative to the first, camera axes")
        .def_readonly("uncertainty", &MultiViewResult::uncertainty,
                      "covariance of the first view's pose, from all views")
        .def_readonly("bent", &MultiViewResult::deformed, "BentVessels from all views, in 3-D; or None")
        .def_readonly("trustworthy", &MultiViewResult::trustworthy, "False: inspect the poses before use")
        .def_property_readonly("warnings", asTuple<&MultiViewResult::warnings>(), "why they are not reliable");
}

/// Returns the covariances as an (n, 3, 3) view. The storage order does not matter, because the matrices are symmetric.
py::array matricesOf(const std::vector<Eigen::Matrix3d>& matrices, const py::handle& owner)
{
    const double* first = matrices.empty() ? nullptr : matrices.front().data();
    return viewOf(first, {static_cast<py::ssize_t>(matrices.size()), 3, 3}, owner);
}

}   // namespace

void bindRegistration(py::module_& module)
{
    bindInput(module);
    bindMetrics(module);
    bindResults(module);
    module.def(
        "registerVessels",
        [](const RegistrationInput& input, const RegistrationOptions& options, const py::object& observe) {
            const Observer observer = observerOf(observe);
            return withoutGil([&] { return registerVessels(input, options, observer); });
        },
        py::arg("input"), py::arg_v("options", RegistrationOptions(), "RegistrationOptions()"),
        py::arg("observe") = py::none(),
        "Finds the pose that aligns the projected tree with the image points. The same input yields bit-identical "
        "results.\n`observe(progress)` may return Verdict.Stop: the result keeps the best pose. Raises Error on "
        "unusable input.");
    module.def("evaluatePose", &evaluatePose, py::arg("input"), py::arg("cameraFromPatient"),
               py::call_guard<py::gil_scoped_release>(),
               "Evaluates a pose (4, 4) without moving it: metrics, residuals of the branches, covariance, warnings.");
    module.def(
        "registerViews",
        [](const std::vector<RegistrationInput>& views, const RegistrationOptions& options, const py::object& observe) {
            const Observer observer = observerOf(observe);
            return withoutGil([&] { return registerViews(views, options, observer); });
        },
        py::arg("views"), py::arg_v("options", RegistrationOptions(), "RegistrationOptions()"),
        py::arg("observe") = py::none(),
        "Registers one tree to two or more views of the same moment, which determines the depth. The initial poses "
        "define\nthe geometry between the cameras; each view but the first may deviate from it by about 0.5 degrees "
        "and 1.5 mm\n(1-sigma per axis), the typical error of headers: `corrections` gives the deviations.");
    module.def(
        "readPose", [](const Path& path) { return readPose(path.string()); }, py::arg("path"),
        "Reads a pose (4, 4) from .json, or an ITK .tfm, .mat or .h5.");
    module.def(
        "writePose", [](const Pose& pose, const Path& path) { writePose(pose, path.string()); },
        py::arg("cameraFromPatient"), py::arg("path"),
        "Writes .json, .tfm or .h5, by the extension; every number is restored to the last bit.");
}

void bindDeformation(py::module_& module)
{
    py::enum_<DeformationVerdict>(module, "BendVerdict", "Whether the image shows deformed vessels.")
        .value("Rigid", DeformationVerdict::Rigid, "no evidence of a deformation")
        .value("Bent", DeformationVerdict::Deformed)
        .value("Unsure", DeformationVerdict::Unsure, "deformed, but how is uncertain: `messages` give the reasons");

    using Deformed = DeformedVessels;
    py::class_<Deformed>(
        module, "BentVessels",
        "Vessels deformed to match the image after their rigid registration (option deformable). One view "
        "determines\nmotion in its image plane; along the ray the vessels keep their shape, and covarianceMm2 reflects "
        "that\nuncertainty. Row i of each array belongs to point i of the registered tree.")
        .def_readonly("verdict", &Deformed::verdict, "rigid, deformed or unsure")
        .def_readonly("tree", &Deformed::tree, "the deformed tree, patient LPS mm")
        .def_property_readonly(
            "displacementMm",
            [](const py::object& self) { return viewOf(self.cast<const Deformed&>().displacementMm, self); },
            "(N, 3), beyond any rigid motion, patient axes")
        .def_property_readonly(
            "covarianceMm2",
            [](const py::object& self) { return matricesOf(self.cast<const Deformed&>().covarianceMm2, self); },
            "(N, 3, 3), of each point's position, camera axes of the first view")
        .def_property_readonly(
            "seenShare", [](const py::object& self) { return viewOf(self.cast<const Deformed&>().seenShare, self); },
            "(N,), of the point's branch: share of its length matched to a traced vessel, 0...1")
        .def_property_readonly(
            "viewPoses",
            [](const Deformed& deformed) {
                py::list poses;
                for (const Pose& pose : deformed.viewPoses) {
                    poses.append(readOnlyArray(pose));
                }
                return py::tuple(poses);
            },
            "(4, 4) for each view: the rigid pose nearest to `tree`, used to project it")
        .def_readonly("logEvidenceGain", &Deformed::logEvidenceGain,
                      "log evidence of the deformation over the rigid pose")
        .def_readonly("meanMotionMm", &Deformed::meanMotionMm, "in the image plane for one view, else in 3-D")
        .def_readonly("largestMotionMm", &Deformed::largestMotionMm, "largest displacement, mm")
        .def_readonly("spreadMm", &Deformed::spreadMm, "rms difference between registrations, in the image plane")
        .def_readonly("placeStdMm", &Deformed::placeStdMm, "rms 1-sigma of a point's position in the image plane")
        .def_readonly("rigidOffMm", &Deformed::rigidOffMm, "mean error of the rigid pose")
        .def_readonly("rigidOffMostMm", &Deformed::rigidOffMostMm, "mean error over the branch where it is largest")
        .def_readonly("rigidOffMostAtBranch", &Deformed::rigidOffMostAtBranch, "id of that branch")
        .def_readonly("explainedShare", &Deformed::explainedShare, "share of the visible tree's length, 0...1")
        .def_readonly("noisePx", &Deformed::noisePx, "estimated noise of a traced vessel")
        .def_property_readonly("messages", asTuple<&Deformed::messages>(),
                               "description of the motion; reasons for the uncertainty")
        .def("__repr__", [](const Deformed& deformed) {
            return py::str("<BentVessels: {}, {:.3g} mm in the mean>")
                .format(toText(deformed.verdict), deformed.meanMotionMm);
        });
}

}   // namespace angiopose::python
