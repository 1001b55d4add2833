#include "angiopose/case.h"

#include "app/python/arrays.h"
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
        .def_property("title", &Case::title, &Case::setTitle)
        .def_property_readonly("tree", &Case::tree)
        .def_property_readonly("angiogram", &Case::angiogram)
        .def_property_readonly("viewCount", &Case::viewCount)
        .def_property("frame", &Case::frame, &Case::setFrame, "from 0; poses turn along where the gantry did")
        .def_property("camera", &Case::camera, &Case::setCamera)
        .def_property("startPose", &Case::startPose, &Case::setStartPose,
                      "(4, 4); setting it moves the current pose there too")
        .def_property("cameraFromPatient", &Case::cameraFromPatient, &Case::setCameraFromPatient,
                      "(4, 4), where the vessels are now; registrations begin here")
        .def_property("options", &Case::options, &Case::setOptions, "a copy; assign to change them")
        .def("setTarget", &Case::setTarget, py::arg("target"), "Image points of this frame, in place of tracing it.")
        .def_property_readonly("warnings", &Case::warnings, "of reading the case and its files")
        .def("__copy__", [](const Case& theCase) { return Case(theCase); })
        .def(
            "__deepcopy__", [](const Case& theCase, const py::dict&) { return Case(theCase); }, py::arg("memo"));
}

void bindReading(py::module_& module)
{
    // Asked in this order: a second text is a path, no observer.
    module.def(
        "readCase",
        [](const std::string& vesselPath, const std::string& imagePath, const VesselReadOptions& options,
           const py::object& observe) {
            const Observer observer = observerOf(observe);
            return withoutLock([&] { return readCase(vesselPath, imagePath, options, observer); });
        },
        py::arg("vesselPath"), py::arg("imagePath"), py::arg_v("options", VesselReadOptions(), "VesselReadOptions()"),
        py::arg("observe") = py::none(),
        "A case of two files: vessels (centrelines, or what they are traced from) and an angiogram.");
    module.def(
        "readCase",
        [](const std::string& path, const py::object& observe) {
            const Observer observer = observerOf(observe);
            return withoutLock([&] { return readCase(path, observer); });
        },
        py::arg("path"), py::arg("observe") = py::none(),
        "Reads a case file and the files it names; vessels given as a scan, a label image or a surface are traced.");
    const py::call_guard<py::gil_scoped_release> unlocked;
    module.def("writeCase", &writeCase, py::arg("theCase"), py::arg("path"), unlocked,
               "Writes a case file; vessels, angiogram and target that come from no file are written beside it.");
    module.def("writeResult", &writeResult, py::arg("theCase"), py::arg("path"), unlocked,
               "Writes result.json of the last registration of the case.");
}

void bindWork(py::module_& module)
{
    const py::call_guard<py::gil_scoped_release> unlocked;
    module.def("targetOf", &targetOf, py::arg("theCase"), unlocked,
               "The image points of the case: given with it, else traced in its frame.");
    module.def("inputOf", &inputOf, py::arg("theCase"), unlocked,
               "What registerVessels needs, as arrays; traces the angiogram where no target is given.");
    module.def(
        "registerCase",
        [](Case& theCase, const py::object& observe) {
            const Observer observer = observerOf(observe);
            return withoutLock([&] { return registerCase(theCase, observer); });
        },
        py::arg("theCase"), py::arg("observe") = py::none(),
        "Registers the case with its options and takes over the pose. Raises for a case of several views.");
    module.def(
        "registerViews",
        [](Case& theCase, const py::object& observe) {
            const Observer observer = observerOf(observe);
            return withoutLock([&] { return registerViews(theCase, observer); });
        },
        py::arg("theCase"), py::arg("observe") = py::none(),
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
        .def_readwrite("branchCount", &SimulationOptions::branchCount)
        .def_readwrite("nonRigidStdMm", &SimulationOptions::nonRigidStdMm, "smooth deformation in the image")
        .def_readwrite("missingBranchShare", &SimulationOptions::missingBranchShare, "not filled in the image")
        .def_readwrite("extraBranchShare", &SimulationOptions::extraBranchShare, "vessels the tree does not have")
        .def_readwrite("frameCount", &SimulationOptions::frameCount);
    py::class_<SimulatedCase>(module, "SimulatedCase", "A case with known answer.")
        .def_readonly("theCase", &SimulatedCase::theCase, "with a start pose as a header gives it")
        .def_property_readonly(
            "trueCameraFromPatient", [](const SimulatedCase& simulated) { return simulated.trueCameraFromPatient; },
            "(4, 4), patient LPS mm to camera mm")
        .def_readonly("trueTarget", &SimulatedCase::trueTarget, "exact projections of what is filled")
        .def_readonly("missingBranchIds", &SimulatedCase::missingBranchIds, "not filled in the image");
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
