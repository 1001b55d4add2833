#include "app/jobs/input_kind.h"

#include "app/messages/says.h"
#include "io/series/slice_record.h"
#include "io/vessel/tree_table.h"
#include "io/volume_file.h"

#include <QCoreApplication>
#include <QFile>
#include <QFileInfo>
#include <QSet>

namespace angiopose::app {
namespace {

/// The words of this file.
struct KindWords {
    Q_DECLARE_TR_FUNCTIONS(angiopose::app::InputKind)
};

constexpr qint64 headSize = 4096;
constexpr int dicomMagicAt = 128;

bool isDicom(const QByteArray& head)
{
    return head.mid(dicomMagicAt, 4) == "DICM";
}

/// X-ray runs are images; what lies in the patient (CT, MR, …) is a slice of a volume.
InputKind kindOfDicom(const QString& path)
{
    const auto images = io::readSliceRecords(path.toStdString());
    if (!images || images.value().slices.empty()) {
        return InputKind::Image;   // reading it says what is wrong
    }
    const std::string& modality = images.value().modality;
    const bool isXray = modality == "XA" || modality == "RF" || modality == "DX" || modality == "CR";
    return !isXray && images.value().slices.front().position ? InputKind::Vessels : InputKind::Image;
}

bool isPicture(const QByteArray& head)
{
    return head.startsWith("\x89PNG") || head.startsWith("\xFF\xD8\xFF") || head.startsWith(QByteArray("II*\0", 4)) ||
           head.startsWith(QByteArray("MM\0*", 4));
}

bool isVtk(const QByteArray& head)
{
    return head.startsWith("# vtk DataFile") || head.contains("<VTKFile");
}

core::Result<InputKind> kindByName(const QFileInfo& file, const QByteArray& head)
{
    static const QSet<QString> images{QStringLiteral("png"),   QStringLiteral("tif"),  QStringLiteral("tiff"),
                                      QStringLiteral("jpg"),   QStringLiteral("jpeg"), QStringLiteral("dcm"),
                                      QStringLiteral("dicom"), QStringLiteral("ima")};
    static const QSet<QString> centerlines{QStringLiteral("vtp"), QStringLiteral("vtk"), QStringLiteral("vtu"),
                                           QStringLiteral("swc"), QStringLiteral("json")};
    static const QSet<QString> surfaces{QStringLiteral("stl"), QStringLiteral("ply"), QStringLiteral("obj")};
    const QString suffix = file.suffix().toLower();
    if (suffix == QLatin1String("angiopose")) {
        return InputKind::Case;
    }
    if (suffix == QLatin1String("csv")) {
        return io::isTreeTable({head.constData(), static_cast<std::size_t>(head.size())}) ? InputKind::Centerline
                                                                                          : InputKind::Target;
    }
    if (centerlines.contains(suffix)) {
        return InputKind::Centerline;
    }
    if (surfaces.contains(suffix)) {
        return InputKind::Vessels;
    }
    if (images.contains(suffix)) {
        return InputKind::Image;
    }
    return core::Error(says::openUnknown(file.fileName().toStdString()));
}

}   // namespace

core::Result<InputKind> inputKindOf(const QString& path)
{
    const QFileInfo info(path);
    const std::string name = info.fileName().toStdString();
    if (!info.exists()) {
        return core::Error(says::openMissing(path.toStdString()));
    }
    if (info.isDir()) {
        return InputKind::Folder;
    }
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly)) {
        return core::Error(says::openUnreadable(name, file.errorString().toStdString()));
    }
    const QByteArray head = file.read(headSize);
    if (head.isEmpty()) {
        return core::Error(says::openEmpty(name));
    }
    // A case file is told by its name: its content is validated on reading.
    if (info.suffix().compare(QLatin1String("angiopose"), Qt::CaseInsensitive) == 0) {
        return InputKind::Case;
    }
    if (isDicom(head)) {
        return kindOfDicom(path);
    }
    if (isPicture(head)) {
        return InputKind::Image;
    }
    if (io::isVolumeFile(path.toStdString())) {
        return InputKind::Vessels;
    }
    if (isVtk(head)) {
        return InputKind::Centerline;
    }
    return kindByName(info, head);
}

QStringList openFilters()
{
    const QString scans = QStringLiteral("*.nii *.nii.gz *.nrrd *.nhdr *.mha *.mhd *.stl *.ply *.obj");
    const QString all =
        QStringLiteral("*.angiopose *.vtp *.vtk *.csv *.swc *.json *.dcm *.png *.tif *.tiff *.jpg *.jpeg ");
    return {KindWords::tr("Cases, vessels and angiograms (%1)").arg(all + scans),
            KindWords::tr("Cases (*.angiopose)"),
            KindWords::tr("Centrelines (*.vtp *.vtk *.csv *.swc *.json)"),
            KindWords::tr("Scans and surfaces (%1 *.dcm)").arg(scans),
            KindWords::tr("Angiograms (*.dcm *.png *.tif *.tiff *.jpg *.jpeg)"),
            KindWords::tr("All files (*)")};
}

}   // namespace angiopose::app