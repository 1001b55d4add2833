#include "angiopose/volume.h"

#include "app/python/read_only.h"
#include "app/python/work.h"

namespace angiopose::python {
namespace {

/// Returns the shape of the voxel array in NumPy order (k, j, i).
std::vector<py::ssize_t> shapeOf(const VolumeGeometry& geometry)
{
    return {geometry.size[2], geometry.size[1], geometry.size[0]};
}

void checkSize(const py::array& voxels, const VolumeGeometry& geometry, const char* name)
{
    const std::vector<py::ssize_t> shape = shapeOf(geometry);
    checkShape(voxels.ndim() == 3 && std::equal(shape.begin(), shape.end(), voxels.shape()), name,
               "(k, j, i), the size of the geometry in reverse");
}

void bindGeometryOfVolumes(py::module_& module)
{
    py::class_<VolumeGeometry>(
        module, "VolumeGeometry",
        "Voxel grid of a volume: voxel (i, j, k) is centered at origin + direction @ (spacing * (i, j, k)).")
        .def(py::init([](const std::array<int, 3>& size, const Eigen::Vector3d& spacingMm,
                         const Eigen::Vector3d& originInPatient, const Eigen::Matrix3d& direction) {
                 return VolumeGeometry{size, spacingMm, originInPatient, direction};
             }),
             py::arg("size"), py::arg("spacingMm"), py::arg_v("originInPatient", Eigen::Vector3d(0, 0, 0), "(0, 0, 0)"),
             py::arg_v("direction", Eigen::Matrix3d(Eigen::Matrix3d::Identity()), "numpy.eye(3)"),
             "size: voxels along i, j, k. spacingMm: (3,). originInPatient: (3,), LPS mm. direction: (3, 3), columns "
             "are\n"
             "the patient directions of i, j, k.")
        .def_property_readonly(
            "size", [](const VolumeGeometry& geometry) { return py::tuple(py::cast(geometry.size)); },
            "voxels along i, j, k")
        .def_property_readonly("spacingMm", asArray<&VolumeGeometry::spacingMm>(), "(3,), voxel spacing")
        .def_property_readonly("originInPatient", asArray<&VolumeGeometry::originInPatient>(),
                               "(3,), center of voxel (0, 0, 0), LPS mm")
        .def_property_readonly("direction", asArray<&VolumeGeometry::direction>(),
                               "(3, 3), columns: patient directions of i, j, k");
}

void bindVolume(py::module_& module)
{
    py::class_<Volume>(module, "Volume", "A CT volume of 16-bit voxels; value (HU) = voxel * slope + intercept.")
        .def(py::init([](const py::object& given, const VolumeGeometry& geometry, double slope, double intercept) {
                 const auto voxels = toIntegerArray<std::int16_t>(given, "voxels");
                 checkSize(voxels, geometry, "voxels");
                 const std::span content(voxels.data(), static_cast<std::size_t>(voxels.size()));
                 return withoutGil([&] { return Volume(content, geometry, slope, intercept); });
             }),
             py::arg("voxels"), py::arg("geometry"), py::arg("slope") = 1.0, py::arg("intercept") = 0.0,
             "voxels: (k, j, i) int16, copied once.")
        .def_property_readonly("geometry", &Volume::geometry, "the voxel grid")
        .def_property_readonly(
            "voxels",
            [](const py::object& self) {
                const auto& volume = self.cast<const Volume&>();
                return viewOf(volume.voxels().data(), shapeOf(volume.geometry()), self);
            },
            "(k, j, i) int16: a read-only view")
        .def_property_readonly("slope", &Volume::slope, "value (HU) per voxel unit")
        .def_property_readonly("intercept", &Volume::intercept, "value (HU) of voxel 0");
}

using Places = std::optional<Array<double>>;

std::vector<Eigen::Vector3d> placesOf(const Places& places, const char* name)
{
    return places ? pointsOf<3>(*places, name) : std::vector<Eigen::Vector3d>();
}

/// Getter that returns a list of points as a read-only copy with shape (n, 3).
template <auto Field>
auto asPlaces()
{
    return [](const VesselTracingOptions& options) {
        const std::vector<Eigen::Vector3d>& places = options.*Field;
        const double* first = places.empty() ? nullptr : places.front().data();
        py::array_t<double> rows({static_cast<py::ssize_t>(places.size()), py::ssize_t(3)}, first);
        rows.attr("flags").attr("writeable") = false;
        return rows;
    };
}

template <auto Field>
auto assignPlaces(const char* name)
{
    return [name](VesselTracingOptions& options, const Places& places) { options.*Field = placesOf(places, name); };
}

void bindOptionsOfTracing(py::module_& module)
{
    using Options = VesselTracingOptions;
    py::enum_<TracedPieces>(module, "TracedPieces", "Components that are traced without a seed.")
        .value("Usual", TracedPieces::Usual)
        .value("All", TracedPieces::All)
        .value("Largest", TracedPieces::Largest);
    py::enum_<VesselLoops>(module, "VesselLoops", "Treatment of vessels that form a loop.")
        .value("Opened", VesselLoops::Opened)
        .value("Kept", VesselLoops::Kept);
    py::class_<VesselTracingOptions>(module, "VesselTracingOptions",
                                     "Tracing options with one set of defaults for every scan; points in LPS mm.")
        .def(py::init([](std::optional<double> threshold, const Places& seedsInPatient, const Places& avoidInPatient,
                         const std::optional<Eigen::Vector3d>& rootInPatient, double minBranchLengthMm,
                         double minBranchRadiusMm, double pointSpacingMm, bool tubesOnly, int threads,
                         TracedPieces pieces, VesselLoops loops) {
                 return VesselTracingOptions{threshold,
                                             placesOf(seedsInPatient, "seedsInPatient"),
                                             placesOf(avoidInPatient, "avoidInPatient"),
                                             rootInPatient,
                                             minBranchLengthMm,
                                             minBranchRadiusMm,
                                             pointSpacingMm,
                                             tubesOnly,
                                             threads,
                                             pieces,
                                             loops};
             }),
             py::kw_only(), py::arg("threshold") = py::none(), py::arg("seedsInPatient") = py::none(),
             py::arg("avoidInPatient") = py::none(), py::arg("rootInPatient") = py::none(),
             py::arg("minBranchLengthMm") = 4.0, py::arg("minBranchRadiusMm") = 0.0, py::arg("pointSpacingMm") = 1.0,
             py::arg("tubesOnly") = false, py::arg("threads") = 0, py::arg("pieces") = TracedPieces::Usual,
             py::arg("loops") = VesselLoops::Opened,
             "threshold: minimum value of the lumen; None: estimated from the blood. seedsInPatient: (n, 3), only "
             "vessels\nconnected to one; None: the great vessel found automatically. avoidInPatient: (n, 3), points "
             "outside\nvessels. rootInPatient: (3,); None: the thickest end. tubesOnly: only thin vessels, from the "
             "seeds.\nthreads: 0: all; the result does not depend on it.\npieces: which are traced without seeds; "
             "Usual: all of a mask, or that of the great vessel of a scan.")
        .def_readwrite("threshold", &Options::threshold,
                       "minimum value of the lumen in the scan (HU for CT); None: estimated from the opacified lumen")
        .def_property("seedsInPatient", asPlaces<&Options::seedsInPatient>(),
                      assignPlaces<&Options::seedsInPatient>("seedsInPatient"),
                      "(n, 3): only vessels connected to one; none: the great vessel found automatically")
        .def_property("avoidInPatient", asPlaces<&Options::avoidInPatient>(),
                      assignPlaces<&Options::avoidInPatient>("avoidInPatient"), "(n, 3): points outside vessels")
        .def_property("rootInPatient", asArray<&Options::rootInPatient>(), assign<&Options::rootInPatient>(),
                      "(3,): the end nearest to it is the root; None: the thickest end")
        .def_readwrite("minBranchLengthMm", &Options::minBranchLengthMm,
                       "branches that extend less beyond their parent's wall are removed")
        .def_readwrite("minBranchRadiusMm", &Options::minBranchRadiusMm,
                       "branches that are thinner on average are removed")
        .def_readwrite("pointSpacingMm", &Options::pointSpacingMm, "distance of points along the branches")
        .def_readwrite("tubesOnly", &Options::tubesOnly,
                       "only thin vessels, from the seeds; tracing ends at chambers, organs and wide vessels")
        .def_readwrite("threads", &Options::threads, "0: all processors; the result does not depend on it")
        .def_readwrite("pieces", &Options::pieces, "components that are traced without a seed")
        .def_readwrite("loops", &Options::loops, "treatment of vessels that form a loop");

    py::class_<VesselReadOptions>(module, "VesselReadOptions", "Options for reading the vessels of a file.")
        .def(py::init([](const std::vector<int>& labels, const std::string& seriesId, double unitMm,
                         const VesselTracingOptions& tracing) {
                 return VesselReadOptions{labels, seriesId, unitMm, tracing};
             }),
             py::kw_only(), py::arg("labels") = std::vector<int>(), py::arg("seriesId") = "", py::arg("unitMm") = 0.0,
             py::arg_v("tracing", VesselTracingOptions(), "VesselTracingOptions()"))
        .def_property("labels", asTuple<&VesselReadOptions::labels>(), assign<&VesselReadOptions::labels>(),
                      "labels of a label image that are vessels; none: all")
        .def_readwrite("seriesId", &VesselReadOptions::seriesId, "series of a DICOM folder with several")
        .def_readwrite("unitMm", &VesselReadOptions::unitMm,
                       "length of one unit of a surface or centerlines; 0: as the file states, else mm")
        .def_readwrite("tracing", &VesselReadOptions::tracing, "its attributes can be set");
}

void bindTraced(py::module_& module)
{
    py::class_<TracedVessels>(module, "TracedVessels", "A vessel tree with the lumen and warnings of its tracing.")
        .def_readonly("tree", &TracedVessels::tree, "root first, then by generation")
        .def_readonly("lumenGeometry", &TracedVessels::lumenGeometry, "voxel grid of the lumen")
        .def_property_readonly(
            "lumen",
            [](const py::object& self) {
                const auto& vessels = self.cast<const TracedVessels&>();
                return viewOf(vessels.lumen.data(), shapeOf(vessels.lumenGeometry), self);
            },
            "(k, j, i) uint8, not 0: traced lumen; a read-only view, (0, 0, 0) if nothing was traced")
        .def_readonly("threshold", &TracedVessels::threshold, "minimum value of the lumen; 0.5 for masks")
        .def_property_readonly("warnings", asTuple<&TracedVessels::warnings>(),
                               "warnings: components that were omitted, loops that were cut, ...");
}

TracedVessels traced(const Volume& volume, const VesselTracingOptions& options, const py::object& observe)
{
    const Observer observer = observerOf(observe);
    return withoutGil([&] { return traceVessels(volume, options, observer); });
}

TracedVessels tracedMask(const py::object& given, const VolumeGeometry& geometry, const VesselTracingOptions& options,
                         const py::object& observe)
{
    const auto mask = toIntegerArray<std::uint8_t>(given, "mask");
    checkSize(mask, geometry, "mask");
    const Observer observer = observerOf(observe);
    const std::span voxels(mask.data(), static_cast<std::size_t>(mask.size()));
    return withoutGil([&] { return traceMask(voxels, geometry, options, observer); });
}

}   // namespace

void bindVolumes(py::module_& module)
{
    bindGeometryOfVolumes(module);
    bindVolume(module);
    bindOptionsOfTracing(module);
    bindTraced(module);
    module.def(
        "readVolume",
        [](const Path& path, const std::string& seriesId, const py::object& observe) {
            const Observer observer = observerOf(observe);
            return withoutGil([&] { return readVolume(path.string(), seriesId, observer); });
        },
        py::arg("path"), py::arg("seriesId") = "", py::arg("observe") = py::none(),
        "Reads NIfTI, NRRD, MetaImage or DICOM (a slice, an enhanced file, a folder).");
    module.def(
        "writeVolume", [](const Volume& volume, const Path& path) { writeVolume(volume, path.string()); },
        py::arg("volume"), py::arg("path"), py::call_guard<py::gil_scoped_release>(),
        "Writes .nii, .nii.gz, .nrrd or .mha, by the extension.");
    module.def("traceVessels", &traced, py::arg("volume"),
               py::arg_v("options", VesselTracingOptions(), "VesselTracingOptions()"), py::arg("observe") = py::none(),
               "Traces the contrast-enhanced vessels of a CT angiogram.");
    module.def("traceMask", &tracedMask, py::arg("mask"), py::arg("geometry"),
               py::arg_v("options", VesselTracingOptions(), "VesselTracingOptions()"), py::arg("observe") = py::none(),
               "Traces the vessels of a mask (k, j, i; not 0: lumen), used unchanged: all its pieces, or those that "
               "contain\nthe seeds.");
    module.def(
        "readVessels",
        [](const Path& path, const VesselReadOptions& options, const py::object& observe) {
            const Observer observer = observerOf(observe);
            return withoutGil([&] { return readVessels(path.string(), options, observer); });
        },
        py::arg("path"), py::arg_v("options", VesselReadOptions(), "VesselReadOptions()"),
        py::arg("observe") = py::none(),
        "Reads vessels from any supported file: centerlines are read; scans, label images and surfaces are traced.");
}

}   // namespace angiopose::python
