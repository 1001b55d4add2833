#include "angiopose/vessel_tree.h"

#include "app/python/read_only.h"
#include "app/python/work.h"

#include <set>

namespace angiopose::python {
namespace {

using OptionalRadii = std::optional<Array<double>>;

VesselTree treeOf(const Array<double>& points, const py::object& branchIds, const OptionalRadii& radiusMm,
                  const std::vector<BranchLabel>& labels)
{
    VesselTree tree{pointsOf<3>(points, "points"), idsOf(branchIds, "branchIds"), valuesOf(radiusMm, "radiusMm"),
                    labels};
    checkRows(tree.branchIds.size(), tree.points.size(), "branchIds");
    checkOptionalRows(tree.radiusMm.size(), tree.points.size(), "radiusMm");
    return tree;
}

Centerline2d centerlineOf(const Array<double>& points, const py::object& curveIds, const OptionalRadii& radiusPx)
{
    Centerline2d centerline{pointsOf<2>(points, "points"), idsOf(curveIds, "curveIds"), valuesOf(radiusPx, "radiusPx")};
    checkOptionalRows(centerline.curveIds.size(), centerline.points.size(), "curveIds");
    checkOptionalRows(centerline.radiusPx.size(), centerline.points.size(), "radiusPx");
    return centerline;
}

void bindTree(py::module_& module)
{
    py::class_<BranchLabel>(module, "BranchLabel", "Properties of one branch besides its points.")
        .def(py::init([](int id, const std::string& name, int generation) {
                 return BranchLabel{id, name, generation};
             }),
             py::arg("id"), py::arg("name") = "", py::arg("generation") = -1)
        .def_readonly("id", &BranchLabel::id, "id of the branch")
        .def_readonly("name", &BranchLabel::name, "name of the vessel; may be empty")
        .def_readonly("generation", &BranchLabel::generation, "0 at the root; -1: unknown");

    py::class_<VesselTree>(module, "VesselTree",
                           "Centerlines of a vessel tree: row i of each array belongs to point i. The points of a "
                           "branch\nare contiguous and ordered along the vessel. Arrays are read-only views.")
        .def(py::init(&treeOf), py::arg("points"), py::arg("branchIds"), py::arg("radiusMm") = py::none(),
             py::arg("labels") = std::vector<BranchLabel>(),
             "points: (N, 3), patient LPS mm. branchIds: (N,). radiusMm: (N,), or None; NaN for whole branches without "
             "radii.")
        .def("__repr__",
             [](const VesselTree& tree) {
                 const std::set<int> branches(tree.branchIds.begin(), tree.branchIds.end());
                 return py::str("<VesselTree: {} points in {} branches>").format(tree.points.size(), branches.size());
             })
        .def_property_readonly(
            "points", [](const py::object& self) { return viewOf(self.cast<const VesselTree&>().points, self); },
            "(N, 3) float64, patient LPS, mm")
        .def_property_readonly(
            "branchIds", [](const py::object& self) { return viewOf(self.cast<const VesselTree&>().branchIds, self); },
            "(N,) int32, the branch id of each point")
        .def_property_readonly(
            "radiusMm", [](const py::object& self) { return viewOf(self.cast<const VesselTree&>().radiusMm, self); },
            "(N,) float64, or (0,); NaN if unknown")
        .def_property_readonly("labels", asTuple<&VesselTree::labels>(), "properties of the branches that have any")
        .def("__len__", [](const VesselTree& tree) { return tree.points.size(); });
}

void bindCenterline(py::module_& module)
{
    py::class_<Centerline2d>(
        module, "Centerline2d",
        "Vessels of an angiogram as points: row i of each array belongs to point i. Arrays are\nread-only views.")
        .def(py::init(&centerlineOf), py::arg("points"), py::arg("curveIds") = py::none(),
             py::arg("radiusPx") = py::none(),
             "points: (M, 2), px, u right and v down, (0, 0) the center of the first pixel. curveIds: (M,), points "
             "of\na curve contiguous and in order; None: the points are unordered, and neighbors in the image are "
             "joined to\ncurves. radiusPx: (M,), with curveIds; or None.")
        .def("__repr__",
             [](const Centerline2d& centerline) {
                 return py::str("<Centerline2d: {} points>").format(centerline.points.size());
             })
        .def_property_readonly(
            "points", [](const py::object& self) { return viewOf(self.cast<const Centerline2d&>().points, self); },
            "(M, 2) float64, px")
        .def_property_readonly(
            "curveIds", [](const py::object& self) { return viewOf(self.cast<const Centerline2d&>().curveIds, self); },
            "(M,) int32, the curve id of each point, or (0,)")
        .def_property_readonly(
            "radiusPx", [](const py::object& self) { return viewOf(self.cast<const Centerline2d&>().radiusPx, self); },
            "(M,) float64, or (0,); NaN if unknown")
        .def("__len__", [](const Centerline2d& centerline) { return centerline.points.size(); });
}

}   // namespace

void bindVessels(py::module_& module)
{
    bindTree(module);
    bindCenterline(module);
    module.def(
        "readVesselTree", [](const Path& path, double unitMm) { return readVesselTree(path.string(), unitMm); },
        py::arg("path"), py::arg("unitMm") = 0.0,
        "Reads VTP/VTU, legacy VTK, CSV, SWC or Slicer curves; `unitMm` is the length of one unit of the file, 0: as "
        "the file states, else mm.");
    module.def(
        "writeVesselTree", [](const VesselTree& tree, const Path& path) { writeVesselTree(tree, path.string()); },
        py::arg("tree"), py::arg("path"), "Writes .vtp, .csv, .swc or .mrk.json (without radii), by the extension.");
    module.def(
        "readCenterline2d", [](const Path& path) { return readCenterline2d(path.string()); }, py::arg("path"),
        "Reads CSV (x,y,branch,radius) or a PNG mask, which is traced.");
    module.def(
        "writeCenterline2d",
        [](const Centerline2d& centerline, const Path& path) { writeCenterline2d(centerline, path.string()); },
        py::arg("centerline"), py::arg("path"), "Writes CSV x,y,branch,radius, px.");
}

}   // namespace angiopose::python
