#include "angiopose/case.h"

#include "app/python/fixed.h"
#include "app/python/work.h"

namespace angiopose::python {
namespace {

void bindCase(py::module_& module)
{
    py::class_<Case>(
        module, "Case",
        "What a case file holds: vessels, angiograms of them (views), geometry, poses, options. Attributes\n"
        "speak of the first view.")
        .def(py::init<const VesselTree&, const Angiogram&>(), py::arg("tree"), py::arg("angiogram"),
             "The start pose is that of the C-arm where the angiogram knows it; else set startPose.")
        .def_property("title", &Case::title, &Case::setTitle, "what the case is called")
        .def_property_readonly("tree", &Case::tree, "the vessels; patient LPS mm")
        .def_property_readonly("angiogram", &Case::angiogram, "of the first view")
        .def_property_readonly("viewCount", &Case::viewCount, "how many angiograms of the vessels it has")
        .def_property("frame", &Case::frame, &Case::setFrame, "from 0; poses turn along where the gantry did")
        .def_property(
            "camera", [](const Case& session) { return Fixed<ProjectionCamera>(session.camera()); }, &Case::setCamera,
            "of the angiogram's size; assign to change it")
        .def_property(
            "cArm", [](const Case& session) { return Fixed<CArm>(session.cArm()); }, &Case::setCArm,
            "assign to change it: camera and start pose follow from it, whatever was set before")
        .def_property(
            "startPose", [](const Case& session) { return fixedArray(session.startPose()); }, &Case::setStartPose,
            "(4, 4); setting it moves the current pose there too")
        .def_property(
            "cameraFromPatient", [](const Case& session) { return fixedArray(session.cameraFromPatient()); },
            &Case::setCameraFromPatient, "(4, 4), where the vessels are now; registrations begin here")
        .def_property(
            "options", [](const Case& session) { return Fixed<RegistrationOptions>(session.options()); },
            &Case::setOptions, "method, settings, locks; assign to change them")
        .def_property(
            "traceOptions", [](const Case& session) { return Fixed<TraceOptions>(session.traceOptions()); },
            &Case::setTraceOptions, "how frames are traced that have no target; assign to change them")
        .def_property(
            "excludedBranchIds", [](const Case& session) { return fixedList(session.excludedBranchIds()); },
            &Case::setExcludedBranchIds, "branches that are not used at all")
        .def_property(
            "auxiliaryBranchIds", [](const Case& session) { return fixedList(session.auxiliaryBranchIds()); },
            &Case::setAuxiliaryBranchIds, "branches that are solved first by methods that alternate")
        .def("setTarget", &Case::setTarget, py::arg("target"), "Image points of this frame, in place of tracing it.")
        .def_property_readonly(
            "warnings", [](const Case& session) { return fixedList(session.warnings()); },
            "of reading the case and its files")
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
    // pybind11 tries the overloads in this order: a second string is a path, not an observer.
    module.def(
        "readCase",
        [](const Path& vesselPath, const Path& imagePath, const VesselReadOptions& options, const py::object& observe) {
            const Observer observer = observerOf(observe);
            return withoutLock([&] { return readCase(vesselPath.string(), imagePath.string(), options, observer); });
        },
        py::arg("vesselPath"), py::arg("imagePath"), py::arg_v("options", VesselReadOptions(), "VesselReadOptions()"),
        py::arg("observe") = py::none(),
        "A case of two files: vessels (centrelines, or what they are traced from) and an angiogram.");
    module.def(
        "readCase",
        [](const Path& path, const py::object& observe) {
            const Observer observer = observerOf(observe);
            return withoutLock([&] { return readCase(path.string(), observer); });
        },
        py::arg("path"), py::arg("observe") = py::none(),
        "Reads a case file and the files it names; vessels given as a scan, a label image or a surface are traced.");
    const py::call_guard<py::gil_scoped_release> unlocked;
    module.def(
        "writeCase", [](Case& session, const Path& path) { writeCase(session, path.string()); }, py::arg("session"),
        py::arg("path"), unlocked,
        "Writes a case file. What comes from no file is written beside it: of a.angiopose the vessels are\n"
        "a.tree.vtp, the angiogram a.angiogram.dcm, a target that was set a.curves.csv.");
    module.def(
        "writeResult", [](const Case& session, const Path& path) { writeResult(session, path.string()); },
        py::arg("session"), py::arg("path"), unlocked, "Writes result.json of the last registration of the case.");
}

void bindWork(py::module_& module)
{
    const py::call_guard<py::gil_scoped_release> unlocked;
    module.def("targetOf", &targetOf, py::arg("session"), unlocked,
               "The image points of the case: given with it, else traced in its frame.");
    module.def(
        "inputOf", &inputOf, py::arg("session"), unlocked,
        "What registerVessels needs, as arrays; traces the angiogram where no target is given. Method, settings and\n"
        "locks of the case are not among it: registerVessels(inputOf(c), c.options) does what registerCase(c)\n"
        "does.");
    module.def(
        "registerCase",
        [](Case& session, const py::object& observe) {
            const Observer observer = observerOf(observe);
            return withoutLock([&] { return registerCase(session, observer); });
        },
        py::arg("session"), py::arg("observe") = py::none(),
        "Registers the case with its options and takes over the pose. Raises for a case of several views.");
    module.def(
        "registerViews",
        [](Case& session, const py::object& observe) {
            const Observer observer = observerOf(observe);
            return withoutLock([&] { return registerViews(session, observer); });
        },
        py::arg("session"), py::arg("observe") = py::none(),
        "Registers all views of a case together and takes over the pose.");
}

void bindSimulation(py::module_& module)
{
    const SimulationOptions usual;
    py::class_<SimulationOptions>(module, "SimulationOptions", "How a case is made up; lengths mm.")
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
                       "of the branches, not filled in the image, 0...1")
        .def_readwrite("extraBranchShare", &SimulationOptions::extraBranchShare,
                       "vessels of the image that the tree does not have, per branch, 0...1")
        .def_readwrite("frameCount", &SimulationOptions::frameCount, "of the run");
    py::class_<SimulatedCase>(module, "SimulatedCase", "A case with known answer.")
        .def_readonly("session", &SimulatedCase::session, "with a start pose as a header gives it")
        .def_property_readonly("trueCameraFromPatient", asArray<&SimulatedCase::trueCameraFromPatient>(),
                               "(4, 4), patient LPS mm to camera mm")
        .def_readonly("trueTarget", &SimulatedCase::trueTarget, "the curves of what is filled, sampled every px")
        .def_property_readonly("missingBranchIds", asTuple<&SimulatedCase::missingBranchIds>(),
                               "not filled in the image");
    module.def("simulateCase", &simulateCase, py::arg("seed"),
               py::arg_v("options", SimulationOptions(), "SimulationOptions()"),
               py::call_guard<py::gil_scoped_release>(),
               "A random tree in a random view of a simulated angiogram. Everything follows from the seed.");
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
