#include "angiopose/case.h"

#include "app/python/read_only.h"
#include "app/python/work.h"

namespace angiopose::python {
namespace {

void bindCase(py::module_& module)
{
    py::class_<Case>(module, "Case",
                     "Contents of a case file: vessels, their angiograms (views), geometry, poses, options. "
                     "Attributes\nrefer to the first view.")
        .def(py::init<const VesselTree&, const Angiogram&>(), py::arg("tree"), py::arg("angiogram"),
             "The initial pose is that of the C-arm if the angiogram gives it; otherwise set startPose.")
        .def_property("title", &Case::title, &Case::setTitle, "name of the case")
        .def_property_readonly("tree", &Case::tree, "the vessels; patient LPS mm")
        .def_property_readonly("angiogram", &Case::angiogram, "of the first view")
        .def_property_readonly("viewCount", &Case::viewCount, "number of angiograms of the vessels")
        .def_property("frame", &Case::frame, &Case::setFrame,
                      "counted from 0; poses rotate with the gantry if it moved")
        .def_property(
            "camera", [](const Case& session) { return ReadOnly<ProjectionCamera>(session.camera()); },
            &Case::setCamera, "same size as the angiogram; assign to change it")
        .def_property(
            "cArm", [](const Case& session) { return ReadOnly<CArm>(session.cArm()); }, &Case::setCArm,
            "assign to change it: recomputes camera and initial pose, replacing earlier values")
        .def_property(
            "startPose", [](const Case& session) { return readOnlyArray(session.initialPose()); },
            &Case::setInitialPose, "(4, 4), the initial pose; setting it also sets the current pose")
        .def_property(
            "cameraFromPatient", [](const Case& session) { return readOnlyArray(session.cameraFromPatient()); },
            &Case::setCameraFromPatient, "(4, 4), the current pose; registrations start from it")
        .def_property(
            "options", [](const Case& session) { return ReadOnly<RegistrationOptions>(session.options()); },
            &Case::setOptions, "method, settings, locks; assign to change them")
        .def_property(
            "traceOptions", [](const Case& session) { return ReadOnly<TraceOptions>(session.traceOptions()); },
            &Case::setTraceOptions, "tracing options for frames without a target; assign to change them")
        .def_property(
            "excludedBranchIds", [](const Case& session) { return readOnlyTuple(session.excludedBranchIds()); },
            &Case::setExcludedBranchIds, "excluded branches")
        .def_property(
            "auxiliaryBranchIds", [](const Case& session) { return readOnlyTuple(session.auxiliaryBranchIds()); },
            &Case::setAuxiliaryBranchIds, "branches that alternating methods solve first")
        .def("setTarget", &Case::setTarget, py::arg("target"),
             "Sets the image points of this frame, instead of tracing it.")
        .def_property_readonly(
            "warnings", [](const Case& session) { return readOnlyTuple(session.warnings()); },
            "warnings from reading the case and its files")
        .def("__repr__",
             [](const Case& session) {
                 return py::str("<Case {!r}: {} views>").format(session.title(), session.viewCount());
             })
        .def("__copy__", [](const Case& session) { return Case(session); })
        .def(
            "__deepcopy__", [](const Case& session, const py::dict&) { return Case(session); }, py::arg("memo"));
}

void bindReading(py::module_& module)
{
    // pybind11 tries the overloads in this order, so that it takes a second string as a path rather than an observer.
    module.def(
        "readCase",
        [](const Path& vesselPath, const Path& imagePath, const VesselReadOptions& options, const py::object& observe) {
            const Observer observer = observerOf(observe);
            return withoutGil([&] { return readCase(vesselPath.string(), imagePath.string(), options, observer); });
        },
        py::arg("vesselPath"), py::arg("imagePath"), py::arg_v("options", VesselReadOptions(), "VesselReadOptions()"),
        py::arg("observe") = py::none(),
        "Builds a case from two files: vessels (centerlines, or an input to trace) and an angiogram.");
    module.def(
        "readCase",
        [](const Path& path, const py::object& observe) {
            const Observer observer = observerOf(observe);
            return withoutGil([&] { return readCase(path.string(), observer); });
        },
        py::arg("path"), py::arg("observe") = py::none(),
        "Reads a case file and the files it refers to; vessels given as a scan, a label image or a surface are "
        "traced.");
    const py::call_guard<py::gil_scoped_release> unlocked;
    module.def(
        "writeCase", [](Case& session, const Path& path) { writeCase(session, path.string()); }, py::arg("session"),
        py::arg("path"), unlocked,
        "Writes a case file. Data without a file of its own is written next to it: for a.angiopose the vessels "
        "are\na.tree.vtp, the angiogram a.angiogram.dcm, a target that was set a.curves.csv.");
    module.def(
        "writeResult", [](const Case& session, const Path& path) { writeResult(session, path.string()); },
        py::arg("session"), py::arg("path"), unlocked, "Writes result.json for the last registration of the case.");
}

void bindWork(py::module_& module)
{
    const py::call_guard<py::gil_scoped_release> unlocked;
    module.def("targetOf", &targetOf, py::arg("session"), unlocked,
               "The image points of the case: its target, or else those traced in its frame.");
    module.def("inputOf", &inputOf, py::arg("session"), unlocked,
               "The arrays that registerVessels needs; traces the angiogram if no target is given. Method, settings "
               "and\nlocks of the case are not included: registerVessels(inputOf(c), c.options) does what "
               "registerCase(c)\ndoes.");
    module.def(
        "registerCase",
        [](Case& session, const py::object& observe) {
            const Observer observer = observerOf(observe);
            return withoutGil([&] { return registerCase(session, observer); });
        },
        py::arg("session"), py::arg("observe") = py::none(),
        "Registers the case with its options and stores the pose in it. Raises for a case of several views.");
    module.def(
        "registerViews",
        [](Case& session, const py::object& observe) {
            const Observer observer = observerOf(observe);
            return withoutGil([&] { return registerViews(session, observer); });
        },
        py::arg("session"), py::arg("observe") = py::none(),
        "Registers all views of a case jointly and stores the poses in it.");
}

void bindSimulation(py::module_& module)
{
    const SimulationOptions usual;
    py::class_<SimulationOptions>(module, "SimulationOptions", "Parameters of a simulated case; lengths in mm.")
        .def(py::init([](int branchCount, double nonRigidStdMm, double missingBranchShare, double extraBranchShare,
                         int frameCount) {
                 return SimulationOptions{branchCount, nonRigidStdMm, missingBranchShare, extraBranchShare, frameCount};
             }),
             py::kw_only(), py::arg("branchCount") = usual.branchCount, py::arg("nonRigidStdMm") = usual.nonRigidStdMm,
             py::arg("missingBranchShare") = usual.missingBranchShare,
             py::arg("extraBranchShare") = usual.extraBranchShare, py::arg("frameCount") = usual.frameCount)
        .def_readwrite("branchCount", &SimulationOptions::branchCount, "1 to 200")
        .def_readwrite("nonRigidStdMm", &SimulationOptions::nonRigidStdMm, "smooth deformation in the image, mm")
        .def_readwrite("missingBranchShare", &SimulationOptions::missingBranchShare,
                       "share of the branches that are unopacified in the image, 0...1")
        .def_readwrite("extraBranchShare", &SimulationOptions::extraBranchShare,
                       "vessels of the image that are not in the tree, per branch, 0...1")
        .def_readwrite("frameCount", &SimulationOptions::frameCount, "number of frames of the run");
    py::class_<SimulatedCase>(module, "SimulatedCase", "A case with known ground truth.")
        .def_readonly("session", &SimulatedCase::session,
                      "the case, with an initial pose derived from the header values")
        .def_property_readonly("trueCameraFromPatient", asArray<&SimulatedCase::trueCameraFromPatient>(),
                               "(4, 4), patient LPS mm to camera mm")
        .def_readonly("trueTarget", &SimulatedCase::trueTarget,
                      "the curves of the opacified branches, sampled every px")
        .def_property_readonly("missingBranchIds", asTuple<&SimulatedCase::missingBranchIds>(),
                               "branches unopacified in the image");
    module.def("simulateCase", &simulateCase, py::arg("seed"),
               py::arg_v("options", SimulationOptions(), "SimulationOptions()"),
               py::call_guard<py::gil_scoped_release>(),
               "Simulates an angiogram of a random tree in a random view. Everything is determined by the seed.");
}

}   // namespace

void bindCases(py::module_& module)
{
    bindCase(module);
    bindReading(module);
    bindWork(module);
    bindSimulation(module);
}

}   // namespace angiopose::python
