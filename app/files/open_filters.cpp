#include "app/files/open_filters.h"

#include <QCoreApplication>

namespace angiopose::app {
namespace {

/// The words of this file.
struct KindWords {
    Q_DECLARE_TR_FUNCTIONS(angiopose::app::InputKind)
};

}   // namespace

QStringList openFilters()
{
    const QString scans = QStringLiteral("*.nii *.nii.gz *.nrrd *.nhdr *.mha *.mhd *.stl *.ply *.obj");
    const QString all = QStringLiteral(
        "*.angiopose *.vtp *.vtk *.csv *.swc *.json *.dcm *.png *.tif *.tiff *.jpg *.jpeg "
        "*.tfm *.mat *.h5 *.txt *.yml *.yaml *.xml *.fcsv ");
    return {KindWords::tr("Cases, vessels and angiograms (%1)").arg(all + scans),
            KindWords::tr("Cases (*.angiopose)"),
            KindWords::tr("Centrelines (*.vtp *.vtk *.csv *.swc *.json)"),
            KindWords::tr("Scans and surfaces (%1 *.dcm)").arg(scans),
            KindWords::tr("Angiograms (*.dcm *.png *.tif *.tiff *.jpg *.jpeg)"),
            KindWords::tr("Poses and points (*.json *.tfm *.mat *.h5 *.txt *.yml *.yaml *.xml *.fcsv)"),
            KindWords::tr("All files (*)")};
}

}   // namespace angiopose::app
