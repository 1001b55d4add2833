#include "app/jobs/input_kind.h"

#include <QCoreApplication>
#include <QFile>
#include <QFileInfo>
#include <QSet>

namespace app {
namespace {

constexpr qint64 headSize = 4096;
constexpr int dicomMagicAt = 128;

bool isDicom(const QByteArray& head)
{
    return head.mid(dicomMagicAt, 4) == "DICM";
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

/// 3-D centreline tables name a z column, 2-D ones do not (FORMATS §4).
InputKind kindOfCsv(const QByteArray& head)
{
    const QByteArray header = head.left(head.indexOf('\n')).toLower().simplified();
    for (const QByteArray& column : header.split(',')) {
        if (column.trimmed() == "z") {
            return InputKind::Centerline;
        }
    }
    return InputKind::Target;
}

core::Error notOurs(const QFileInfo& file)
{
    return {file.fileName().toStdString() +
            " is not a file that AngioPose opens. Open a case (.angiopose), a centreline (VTP, VTK, CSV, SWC) or an "
            "angiogram (DICOM, PNG, TIFF)."};
}

core::Result<InputKind> kindByName(const QFileInfo& file, const QByteArray& head)
{
    static const QSet<QString> images{QStringLiteral("png"),   QStringLiteral("tif"),  QStringLiteral("tiff"),
                                      QStringLiteral("jpg"),   QStringLiteral("jpeg"), QStringLiteral("dcm"),
                                      QStringLiteral("dicom"), QStringLiteral("ima")};
    static const QSet<QString> centerlines{QStringLiteral("vtp"), QStringLiteral("vtk"), QStringLiteral("vtu"),
                                           QStringLiteral("swc")};
    const QString suffix = file.suffix().toLower();
    if (suffix == QLatin1String("angiopose")) {
        return InputKind::Case;
    }
    if (suffix == QLatin1String("csv")) {
        return kindOfCsv(head);
    }
    if (centerlines.contains(suffix)) {
        return InputKind::Centerline;
    }
    if (images.contains(suffix)) {
        return InputKind::Image;
    }
    return notOurs(file);
}

}   // namespace

core::Result<InputKind> inputKindOf(const QString& path)
{
    const QFileInfo info(path);
    const std::string name = info.fileName().toStdString();
    if (!info.exists()) {
        return core::Error{path.toStdString() + " does not exist. Check the name, or whether its drive is mounted."};
    }
    if (info.isDir()) {
        return core::Error{name + " is a folder. Open the files inside it."};
    }
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly)) {
        return core::Error{name + " cannot be read: " + file.errorString().toStdString() + ". Check its permissions."};
    }
    const QByteArray head = file.read(headSize);
    if (head.isEmpty()) {
        return core::Error{name + " is empty. Copy the file again from where it came from."};
    }
    // A case file is told by its name: its content is validated on reading.
    if (info.suffix().compare(QLatin1String("angiopose"), Qt::CaseInsensitive) == 0) {
        return InputKind::Case;
    }
    if (isDicom(head) || isPicture(head)) {
        return InputKind::Image;
    }
    if (isVtk(head)) {
        return InputKind::Centerline;
    }
    return kindByName(info, head);
}

QStringList openFilters()
{
    const auto text = [](const char* words) { return QCoreApplication::translate("app::InputKind", words); };
    const QString all = QStringLiteral("*.angiopose *.vtp *.vtk *.csv *.swc *.dcm *.png *.tif *.tiff *.jpg *.jpeg");
    return {text("Cases, centrelines and angiograms (%1)").arg(all), text("Cases (*.angiopose)"),
            text("Centrelines (*.vtp *.vtk *.csv *.swc)"), text("Angiograms (*.dcm *.png *.tif *.tiff *.jpg *.jpeg)"),
            text("All files (*)")};
}

}   // namespace app
