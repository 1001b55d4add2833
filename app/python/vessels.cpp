#include "angiopose/vessel_tree.h"

#include "app/python/arrays.h"
#include "app/python/work.h"

namespace angiopose::python {
namespace {

using OptionalRadii = std::optional<Array<double>>;

void bindTree(py::module_& module)
{
    py::class_<BranchLabel>(module, "BranchLabel", "What is known of one branch beside its points.")
        .def(py::init([](int id, const std::string& name, int generation) {
                 return BranchLabel{id, name, generation};
             }),
             py::arg("id"), py::arg("name") = "", py::arg("generation") = -1)
        .def_readonly("id", &BranchLabel::id)
        .def_readonly("name", &BranchLabel::name)
        .def_readonly("generation", &BranchLabel::generation, "0 begins at the root; -1: not known");

    py::class_<VesselTree>(
        module, "VesselTree",
        "Centrelines of a vessel tree: row i of each array tells of point i. The points of a branch\n"
        "stand together, in order along the vessel. Arrays are read-only views.")
        .def(py::init([](const Array<double>& points, const py::object& branchIds, const OptionalRadii& radiusMm,
                         const std::vector<BranchLabel>& labels) {
                 return VesselTree{pointsOf<3>(points, "points"), idsOf(branchIds, "branchIds"),
                                   valuesOf(radiusMm, "radiusMm"), labels};
             }),
             py::arg("points"), py::arg("branchIds"), py::arg("radiusMm") = py::none(),
             py::arg("labels") = std::vector<BranchLabel>(),
             "points: (N, 3), patient LPS mm. branchIds: (N,). radiusMm: (N,), or None; NaN along branches without.")
        .def_property_readonly(
            "points", [](const py::object& self) { return viewOf(self.cast<const VesselTree&>().points, self); },
            "(N, 3) float64, patient LPS, mm")
        .def_property_readonly(
            "branchIds", [](const py::object& self) { return viewOf(self.cast<const VesselTree&>().branchIds, self); },
            "(N,) int32, the branch of each point")
        .def_property_readonly(
            "radiusMm", [](const py::object& self) { return viewOf(self.cast<const VesselTree&>().radiusMm, self); },
            "(N,) float64, or (0,); NaN where not known")
        .def_readonly("labels", &VesselTree::labels)
        .def("__len__", [](const VesselTree& tree) { return tree.points.size(); });
}

void bindCenterline(py::module_& module)
{
    py::class_<Centerline2d>(module, "Centerline2d",
                             "Vessels of an angiogram as points: row i of each array tells of point i. Arrays are\n"
                             "read-only views.")
        .def(py::init([](const Array<double>& points, const py::object& curveIds, const OptionalRadii& radiusPx) {
                 return Centerline2d{pointsOf<2>(points, "points"), idsOf(curveIds, "curveIds"),
                                     valuesOf(radiusPx, "radiusPx")};
             }),
             py::arg("points"), py::arg("curveIds") = py::none(), py::arg("radiusPx") = py::none(),
             "points: (M, 2), px, u right and v down, (0, 0) the centre of the first pixel. curveIds: (M,), points of "
             "a\n"
             "curve together and in order; None: the points are in no order. radiusPx: (M,) or None.")
        .def_property_readonly(
            "points", [](const py::object& self) { return viewOf(self.cast<const Centerline2d&>().points, self); },
            "(M, 2) float64, px")
        .def_property_readonly(
            "curveIds", [](const py::object& self) { return viewOf(self.cast<const Centerline2d&>().curveIds, self); },
            "(M,) int32, the curve of each point, or (0,)")
        .def_property_readonly(
            "radiusPx", [](const py::object& self) { return viewOf(self.cast<const Centerline2d&>().radiusPx, self); },
            "(M,) float64, or (0,); NaN where not known")
        .def("__len__", [](const Centerline2d& centerline) { return centerline.points.size(); });
}

}   // namespace

void bindVessels(py::module_& module)
{
    bindTree(module);
    bindCenterline(module);
    module.def("readVesselTree", &readVesselTree, py::arg("path"), py::arg("unitMm") = 1.0,
               "From VTP/VTU, legacy VTK, CSV, SWC or Slicer curves; `unitMm` is the length of one unit of the file.");
    module.def("writeVesselTree", &writeVesselTree, py::arg("tree"), py::arg("path"),
               "To .vtp, .csv, .swc or .mrk.json (without radii), by the extension.");
    module.def("readCenterline2d", &readCenterline2d, py::arg("path"),
               "From CSV (x,y,branch,radius) or a PNG mask, which is traced.");
    module.def("writeCenterline2d", &writeCenterline2d, py::arg("centerline"), py::arg("path"),
               "To CSV x,y,branch,radius, px.");
}

}   // namespace angiopose::python
