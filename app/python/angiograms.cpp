#include "angiopose/angiogram.h"

#include "app/python/read_only.h"
#include "app/python/work.h"

namespace angiopose::python {
namespace {

Angiogram angiogramOf(const Array<float>& frames, Polarity polarity, const CArm& cArm)
{
    checkShape(frames.ndim() == 3 || frames.ndim() == 2, "frames", "(frames, height, width)");
    if (frames.ndim() == 3 && (frames.shape(2) == 3 || frames.shape(2) == 4)) {
        throw py::value_error(
            "frames must be gray values of shape (frames, height, width); these look like colors, (height, width, 3 or "
            "4)");
    }
    const bool isOne = frames.ndim() == 2;
    const int height = static_cast<int>(frames.shape(isOne ? 0 : 1));
    const int width = static_cast<int>(frames.shape(isOne ? 1 : 2));
    const py::ssize_t size = py::ssize_t(height) * width;
    std::vector<Image> images;
    for (py::ssize_t i = 0; i < (isOne ? 1 : frames.shape(0)); ++i) {
        const float* first = frames.data() + i * size;
        images.push_back({width, height, {first, first + size}});
    }
    return withoutGil([&] { return Angiogram(images, polarity, cArm); });
}

void bindRun(py::module_& module)
{
    py::class_<Angiogram>(module, "Angiogram", "An X-ray run: frames of equal size with the geometry from the header.")
        .def(py::init(&angiogramOf), py::arg("frames"), py::arg("polarity") = Polarity::VesselsDark,
             py::arg_v("cArm", CArm(), "CArm()"),
             "frames: (frames, height, width), or (height, width); copied as float32.")
        .def_property_readonly("width", &Angiogram::width, "columns, px")
        .def_property_readonly("height", &Angiogram::height, "rows, px")
        .def_property_readonly("frameCount", &Angiogram::frameCount, "number of frames of the run")
        .def(
            "frame",
            [](const py::object& self, int frame) {
                const auto& run = self.cast<const Angiogram&>();
                return viewOf(run.pixels(frame).data(), {run.height(), run.width()}, self);
            },
            py::arg("frame"), "(height, width) float32: a read-only view of the stored values.")
        .def_property_readonly("polarity", &Angiogram::polarity, "whether vessels are dark or bright")
        .def_property_readonly(
            "cArm", [](const Angiogram& run) { return ReadOnly<CArm>(run.cArm()); }, "from the header; a copy")
        .def_property_readonly("frameTimeMs", &Angiogram::frameTimeMs, "time between frames; 0: unknown")
        .def_property_readonly("suggestedFrame", &Angiogram::suggestedFrame, "the peak-opacification frame")
        .def_property_readonly(
            "warnings", [](const Angiogram& run) { return readOnlyTuple(run.warnings()); },
            "warnings from reading the file");
}

void bindTrace(py::module_& module)
{
    const TraceOptions usual;
    py::class_<TraceOptions>(module, "TraceOptions",
                             "Lengths in px of a 512 x 512 frame; they scale up with larger frames.")
        .def(py::init([](double minVesselRadiusPx, double maxVesselRadiusPx, int minBranchLengthPx,
                         int minComponentLengthPx, double sensitivity) {
                 return TraceOptions{minVesselRadiusPx, maxVesselRadiusPx, minBranchLengthPx, minComponentLengthPx,
                                     sensitivity};
             }),
             py::kw_only(), py::arg("minVesselRadiusPx") = usual.minVesselRadiusPx,
             py::arg("maxVesselRadiusPx") = usual.maxVesselRadiusPx,
             py::arg("minBranchLengthPx") = usual.minBranchLengthPx,
             py::arg("minComponentLengthPx") = usual.minComponentLengthPx, py::arg("sensitivity") = usual.sensitivity)
        .def("__copy__", [](const TraceOptions& options) { return options; })
        .def_readwrite("minVesselRadiusPx", &TraceOptions::minVesselRadiusPx, "thinnest vessel to detect")
        .def_readwrite("maxVesselRadiusPx", &TraceOptions::maxVesselRadiusPx,
                       "widest vessel to detect; 0: from pixel spacing and magnification")
        .def_readwrite("minBranchLengthPx", &TraceOptions::minBranchLengthPx, "shorter spurs are removed")
        .def_readwrite("minComponentLengthPx", &TraceOptions::minComponentLengthPx, "shorter components are removed")
        .def_readwrite("sensitivity", &TraceOptions::sensitivity, "above 1: also detect fainter vessels");
    bindReadOnly<TraceOptions>(module, "_FixedTraceOptions");

    py::class_<AngiogramTrace>(module, "AngiogramTrace", "Result of tracing one frame. Arrays are read-only views.")
        .def_readonly("centerline", &AngiogramTrace::centerline, "the vessels as curves, px")
        .def_property_readonly("suspectCurves", asTuple<&AngiogramTrace::suspectCurves>(),
                               "ids of curves that may be catheters, guidewires or bone edges")
        .def_property_readonly(
            "vesselness",
            [](const py::object& self) { return viewOf(self.cast<const AngiogramTrace&>().vesselness, self); },
            "(height, width) float32, 0...1")
        .def_property_readonly(
            "vesselMask",
            [](const py::object& self) { return viewOf(self.cast<const AngiogramTrace&>().vesselMask, self); },
            "(height, width) uint8, not 0: vessel")
        .def_property_readonly(
            "fieldMask",
            [](const py::object& self) { return viewOf(self.cast<const AngiogramTrace&>().fieldMask, self); },
            "(height, width) uint8, not 0: exposed part of the image")
        .def_property_readonly("warnings", asTuple<&AngiogramTrace::warnings>(),
                               "warnings, e.g. that no contrast agent arrives in this run");
}

}   // namespace

void bindAngiograms(py::module_& module)
{
    py::enum_<Polarity>(module, "Polarity")
        .value("VesselsDark", Polarity::VesselsDark)
        .value("VesselsBright", Polarity::VesselsBright);
    bindRun(module);
    bindTrace(module);
    const py::call_guard<py::gil_scoped_release> unlocked;
    module.def(
        "readAngiogram", [](const Path& path) { return readAngiogram(path.string()); }, py::arg("path"), unlocked,
        "Reads DICOM XA (single and multi-frame), PNG, TIFF or JPEG.");
    module.def(
        "writeAngiogram",
        [](const Angiogram& angiogram, const Path& path) { writeAngiogram(angiogram, path.string()); },
        py::arg("angiogram"), py::arg("path"), unlocked,
        "Writes uncompressed multi-frame 16-bit DICOM XA with the geometry of its C-arm.");
    module.def(
        "traceAngiogram",
        [](const Array<float>& frame, Polarity polarity, const TraceOptions& options) {
            const Image image = imageOf(frame, "frame");
            return withoutGil([&] { return traceAngiogram(image, polarity, options); });
        },
        py::arg("frame"), py::arg("polarity") = Polarity::VesselsDark,
        py::arg_v("options", TraceOptions(), "TraceOptions()"), "Traces the vessels of one image (height, width).");
    module.def("traceFrame", &traceFrame, py::arg("run"), py::arg("frame"),
               py::arg_v("options", TraceOptions(), "TraceOptions()"), unlocked,
               "Traces the vessels of one frame of a run, with less noise where the run is static. Registering\na case "
               "uses this function.");
}

}   // namespace angiopose::python
