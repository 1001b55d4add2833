#include "app/preferences/save_folder.h"

#include "app/preferences/settings.h"
#include "io/sharing/audit_file.h"

#include <QDir>
#include <QFileInfo>
#include <QStandardPaths>

namespace angiopose::app {
namespace {

/// Returns whether the folder contains files of the program itself (including the sample case), where users would not
/// look for an export.
bool isProgramFolder(const QString& folder)
{
    const QString ours = QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation);
    return folder == ours || folder.startsWith(ours + QLatin1Char('/'));
}

bool canHold(const QString& folder)
{
    const QFileInfo info(folder);
    return !folder.isEmpty() && info.isDir() && info.isWritable() && !isProgramFolder(info.absoluteFilePath());
}

}   // namespace

QString saveFolder(const QString& casePath)
{
    const QString besideCase = casePath.isEmpty() ? QString() : QFileInfo(casePath).absolutePath();
    const QString documents = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
    for (const QString& folder : {settings::saveFolder.read(), besideCase, settings::lastFolder.read(), documents}) {
        if (canHold(folder)) {
            return folder;
        }
    }
    return QDir::homePath();
}

QString suggestedPath(const QString& casePath, const QString& name)
{
    return QDir(saveFolder(casePath)).filePath(name);
}

void rememberSaveFolder(const QString& writtenPath)
{
    settings::saveFolder.write(QFileInfo(writtenPath).absolutePath());
}

QString auditPath()
{
    const std::string forced = io::auditFileFromEnvironment();
    return forced.empty() ? settings::auditFile.read() : QString::fromStdString(forced);
}

}   // namespace angiopose::app
