#include "angiopose/geometry.h"

#include "app/python/read_only.h"
#include "app/python/work.h"

namespace angiopose::python {
namespace {

void bindCamera(py::module_& module)
{
    py::class_<ProjectionCamera>(module, "ProjectionCamera",
                                 "Pinhole model of X-ray source and detector: u = fx X/Z + cx, v = fy Y/Z + cy (px).")
        .def(py::init([](double fx, double fy, double cx, double cy, int width, int height) {
                 return ProjectionCamera{fx, fy, cx, cy, width, height};
             }),
             py::arg("fx"), py::arg("fy"), py::arg("cx"), py::arg("cy"), py::arg("width"), py::arg("height"),
             "All px. fx is negative in a standard image, which is seen from the detector: with the wrong sign the "
             "image\nis mirrored, and a tree with few branches may still fit it. cameraFromCArm sets the correct sign.")
        .def("__copy__", [](const ProjectionCamera& camera) { return camera; })
        .def("__repr__",
             [](const ProjectionCamera& camera) {
                 return py::str("ProjectionCamera(fx={}, fy={}, cx={}, cy={}, width={}, height={})")
                     .format(camera.fx, camera.fy, camera.cx, camera.cy, camera.width, camera.height);
             })
        .def_readwrite("fx", &ProjectionCamera::fx, "px; negative in a standard image, which is seen from the detector")
        .def_readwrite("fy", &ProjectionCamera::fy, "px")
        .def_readwrite("cx", &ProjectionCamera::cx, "px")
        .def_readwrite("cy", &ProjectionCamera::cy, "px")
        .def_readwrite("width", &ProjectionCamera::width, "columns of the image")
        .def_readwrite("height", &ProjectionCamera::height, "rows of the image");
    bindReadOnly<ProjectionCamera>(module, "_FixedCamera");
}

using Length = std::optional<double>;

void bindCArm(py::module_& module)
{
    py::class_<CArm>(module, "CArm", "C-arm as DICOM describes it; lengths in mm, angles in degrees, None: unknown.")
        .def(py::init([](Length sourceToDetectorMm, Length sourceToPatientMm, Length columnSpacingMm,
                         Length rowSpacingMm, Length primaryAngleDeg, Length secondaryAngleDeg, Length rollDeg,
                         Length principalPointUPx, Length principalPointVPx, bool mirrored,
                         const std::optional<Eigen::Vector3d>& isocenterInPatientMm) {
                 return CArm{
                     sourceToDetectorMm,  sourceToPatientMm, columnSpacingMm,   rowSpacingMm,      primaryAngleDeg,
                     secondaryAngleDeg,   rollDeg,           principalPointUPx, principalPointVPx, mirrored,
                     isocenterInPatientMm};
             }),
             py::kw_only(), py::arg("sourceToDetectorMm") = py::none(), py::arg("sourceToPatientMm") = py::none(),
             py::arg("columnSpacingMm") = py::none(), py::arg("rowSpacingMm") = py::none(),
             py::arg("primaryAngleDeg") = py::none(), py::arg("secondaryAngleDeg") = py::none(),
             py::arg("rollDeg") = py::none(), py::arg("principalPointUPx") = py::none(),
             py::arg("principalPointVPx") = py::none(), py::arg("mirrored") = false,
             py::arg("isocentreInPatientMm") = py::none())
        .def("__copy__", [](const CArm& cArm) { return cArm; })
        .def_readwrite("sourceToDetectorMm", &CArm::sourceToDetectorMm, "mm, source to detector (SID)")
        .def_readwrite("sourceToPatientMm", &CArm::sourceToPatientMm, "mm, source to isocenter")
        .def_readwrite("columnSpacingMm", &CArm::columnSpacingMm, "pixel pitch on the detector along u")
        .def_readwrite("rowSpacingMm", &CArm::rowSpacingMm, "pixel pitch on the detector along v")
        .def_readwrite("primaryAngleDeg", &CArm::primaryAngleDeg, "LAO +, RAO -")
        .def_readwrite("secondaryAngleDeg", &CArm::secondaryAngleDeg, "CRA +, CAU -")
        .def_readwrite("rollDeg", &CArm::rollDeg, "clockwise rotation of the image on screen; None: 0")
        .def_readwrite("principalPointUPx", &CArm::principalPointUPx, "None: image center")
        .def_readwrite("principalPointVPx", &CArm::principalPointVPx, "None: image center")
        .def_readwrite("mirrored", &CArm::mirrored, "True: shown as seen from the source")
        .def_property("isocentreInPatientMm", asArray<&CArm::isocenterInPatientMm>(),
                      assign<&CArm::isocenterInPatientMm>(), "(3,), patient LPS; None: unknown");
    bindReadOnly<CArm>(module, "_FixedCArm");
}

py::object projected(const ProjectionCamera& camera, const Pose& cameraFromPatient, const Array<double>& points)
{
    const bool isOne = points.ndim() == 1;
    checkShape((isOne && points.size() == 3) || (points.ndim() == 2 && points.shape(1) == 3), "points",
               "(N, 3) or (3,)");
    const py::ssize_t count = points.size() / 3;
    py::array_t<double> pixels({count, py::ssize_t(2)});
    for (py::ssize_t i = 0; i < count; ++i) {
        const auto pixel = project(camera, cameraFromPatient, Eigen::Vector3d(points.data() + 3 * i));
        const double unknown = std::numeric_limits<double>::quiet_NaN();
        *pixels.mutable_data(i, 0) = pixel ? pixel->x() : unknown;
        *pixels.mutable_data(i, 1) = pixel ? pixel->y() : unknown;
    }
    return isOne ? py::object(pixels[py::int_(0)]) : py::object(pixels);
}

}   // namespace

void bindGeometry(py::module_& module)
{
    py::enum_<Verdict>(module, "Verdict", "Return value of a progress observer; None counts as Continue.")
        .value("Continue", Verdict::Continue)
        .value("Stop", Verdict::Stop);
    py::class_<Progress>(module, "Progress",
                         "Progress of a long operation. The last three attributes are set while a registration runs.")
        .def_readonly(
            "stage", &Progress::stage,
            "\"reading\"; during a registration \"search\", \"refine\", \"settle\", ...; during tracing its steps")
        .def_readonly("fraction", &Progress::fraction, "0...1, never decreasing")
        .def_readonly("view", &Progress::view, "index of the view concerned, from 0")
        .def_readonly("iteration", &Progress::iteration, "iterations of the solver since its start")
        .def_readonly("medianDistancePx", &Progress::medianDistancePx,
                      "median distance of tree points to their nearest image point")
        .def_property_readonly("cameraFromPatient", asArray<&Progress::cameraFromPatient>(),
                               "(4, 4), best pose so far, patient LPS mm to camera mm; or None");
    bindCamera(module);
    bindCArm(module);
    module.def("cameraFromCArm", &cameraFromCArm, py::arg("cArm"), py::arg("width"), py::arg("height"),
               "Computes the camera of a C-arm for images of this size; needs sourceToDetectorMm and the spacings.");
    module.def("cameraFromPatient", &cameraFromPatient, py::arg("cArm"), py::arg("isocentreInPatient"),
               "Computes the pose (4, 4) of a C-arm that rotates about `isocentreInPatient` ((3,), LPS mm); "
               "needs\nsourceToPatientMm and both angles.");
    module.def("project", &projected, py::arg("camera"), py::arg("cameraFromPatient"), py::arg("points"),
               "Projects patient points (N, 3) in LPS mm to image points (N, 2) in px, or one (3,) to (2,); NaN for "
               "points\nat or behind the source.");
}

}   // namespace angiopose::python
