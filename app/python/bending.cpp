#include "angiopose/bending.h"

#include "app/python/fixed.h"
#include "app/python/work.h"

namespace angiopose::python {
namespace {

/// Symmetric, so that rows and columns may change places.
py::array matricesOf(const std::vector<Eigen::Matrix3d>& matrices, const py::handle& owner)
{
    const double* first = matrices.empty() ? nullptr : matrices.front().data();
    return viewOf(first, {static_cast<py::ssize_t>(matrices.size()), 3, 3}, owner);
}

}   // namespace

void bindBending(py::module_& module)
{
    py::enum_<BendVerdict>(module, "BendVerdict", "Whether the image shows the vessels bent.")
        .value("Rigid", BendVerdict::Rigid, "nothing speaks for a bend")
        .value("Bent", BendVerdict::Bent)
        .value("Unsure", BendVerdict::Unsure, "bent, but how is not certain: `messages` say why");

    using Bent = BentVessels;
    py::class_<Bent>(
        module, "BentVessels",
        "Vessels bent onto the image after their rigid registration (option deformable). One view tells\n"
        "motion in its image plane; along the ray the vessels keep their shape, and covarianceMm2 says how\n"
        "little is known there. Row i of each array tells of point i of the tree that was registered.")
        .def_readonly("verdict", &Bent::verdict, "rigid, bent or unsure")
        .def_readonly("tree", &Bent::tree, "as it was in the image, patient LPS mm")
        .def_property_readonly(
            "displacementMm",
            [](const py::object& self) { return viewOf(self.cast<const Bent&>().displacementMm, self); },
            "(N, 3), beyond any rigid motion, patient axes")
        .def_property_readonly(
            "covarianceMm2",
            [](const py::object& self) { return matricesOf(self.cast<const Bent&>().covarianceMm2, self); },
            "(N, 3, 3), of each point's place, camera axes of the first view")
        .def_property_readonly(
            "seenShare", [](const py::object& self) { return viewOf(self.cast<const Bent&>().seenShare, self); },
            "(N,), of the point's branch: share of its length that found a vessel, 0...1")
        .def_property_readonly(
            "viewPoses",
            [](const Bent& bent) {
                py::list poses;
                for (const Pose& pose : bent.viewPoses) {
                    poses.append(fixedArray(pose));
                }
                return py::tuple(poses);
            },
            "(4, 4) of each view: the rigid pose nearest to `tree`, which it is projected with")
        .def_readonly("logEvidenceGain", &Bent::logEvidenceGain, "of bent vessels over rigid ones")
        .def_readonly("meanMotionMm", &Bent::meanMotionMm, "in the image plane of one view, else in space")
        .def_readonly("largestMotionMm", &Bent::largestMotionMm, "likewise")
        .def_readonly("spreadMm", &Bent::spreadMm, "rms difference between runs, in the image plane")
        .def_readonly("placeStdMm", &Bent::placeStdMm, "rms 1-sigma of a point's place in the image plane")
        .def_readonly("rigidOffMm", &Bent::rigidOffMm, "how far the rigid pose lies off, in the mean")
        .def_readonly("rigidOffMostMm", &Bent::rigidOffMostMm, "in the mean over the branch where it is most")
        .def_readonly("rigidOffMostAtBranch", &Bent::rigidOffMostAtBranch, "which branch that is")
        .def_readonly("explainedShare", &Bent::explainedShare, "of the visible tree's length, 0...1")
        .def_readonly("noisePx", &Bent::noisePx, "learned, of a traced vessel")
        .def_property_readonly("messages", asTuple<&Bent::messages>(), "what moved, in words; why it is unsure")
        .def("__repr__", [](const Bent& bent) {
            return py::str("<BentVessels: {}, {:.3g} mm in the mean>").format(toText(bent.verdict), bent.meanMotionMm);
        });
}

}   // namespace angiopose::python
