#include "app/files/recent_cases.h"

#include "app/preferences/private_mode.h"
#include "app/preferences/settings.h"
#include "app/texts/overlay_image.h"
#include "core/support/quantile.h"
#include "core/tracing/angiogram/frame/burned_in_text.h"
#include "io/image_file.h"

#include <QCryptographicHash>
#include <QDir>
#include <QFileInfo>
#include <QStandardPaths>
#include <algorithm>
#include <filesystem>

namespace angiopose::app {
namespace {

QString folderName()
{
    return QStandardPaths::writableLocation(QStandardPaths::CacheLocation) + QStringLiteral("/cases");
}

/// Returns a file name that reveals nothing about the case.
QString pictureName(const QString& casePath)
{
    const QByteArray path = QFileInfo(casePath).absoluteFilePath().toUtf8();
    return QString::fromLatin1(QCryptographicHash::hash(path, QCryptographicHash::Sha256).toHex().left(32)) +
           QStringLiteral(".png");
}

/// Returns a run with only this frame, in which burned-in text is replaced by a uniform gray.
std::shared_ptr<const core::Angiogram> withoutLetters(const core::Angiogram& run, int frame)
{
    core::Angiogram shown;
    shown.polarity = run.polarity;
    shown.cArm = run.cArm;
    shown.frames = {run.frames[static_cast<std::size_t>(frame)]};
    core::ImageF& picture = shown.frames.front();
    const core::Mask2d letters = core::burnedInTextMask(picture, core::thoroughMaxLetterHeight);
    const auto gray =
        static_cast<float>(core::quantile(std::vector<double>(picture.pixels.begin(), picture.pixels.end()), 0.5));
    for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
        picture.pixels[i] = letters.pixels[i] != 0 ? gray : picture.pixels[i];
    }
    return std::make_shared<const core::Angiogram>(std::move(shown));
}

/// Gives the thumbnail the time stamp of its case file, so that it is not shown for another case at the same path, e.g.
/// on another USB drive.
void markAsOf(const std::string& picturePath, const std::string& casePath)
{
    std::error_code failed;
    const auto time = std::filesystem::last_write_time(casePath, failed);
    if (!failed) {
        std::filesystem::last_write_time(picturePath, time, failed);   // if this fails, the thumbnail is not shown
    }
}

constexpr qsizetype keptCases = 30;   // maximum number of cases in addition to the pinned ones

void store(const QStringList& cases)
{
    if (cases != settings::recentCases.read()) {
        settings::recentCases.write(cases);
        pruneCaseThumbnails(cases);
    }
}

}   // namespace

QString caseThumbnailPath(const QString& casePath)
{
    return folderName() + QLatin1Char('/') + pictureName(casePath);
}

bool storeCaseThumbnail(const core::Case& session, const QString& casePath)
{
    const auto& run = session.shown().angiogram;
    const int frame = session.shown().frame;
    if (!run || frame < 0 || frame >= run->frameCount()) {
        return false;
    }
    core::Case pictured = session;
    pictured.shown().angiogram = withoutLetters(*run, frame);
    pictured.shown().frame = 0;
    const auto picture = drawThumbnail(pictured, caseThumbnailWidthPx);
    if (!picture || !QDir().mkpath(folderName())) {
        return false;
    }
    QFile::setPermissions(folderName(), QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner);
    const std::string path = caseThumbnailPath(casePath).toStdString();
    const bool isWritten = static_cast<bool>(io::writePng(picture.value(), path));
    markAsOf(path, casePath.toStdString());
    return isWritten;
}

QImage caseThumbnail(const QString& casePath)
{
    return QImage(caseThumbnailPath(casePath));
}

void pruneCaseThumbnails(const QStringList& casePaths)
{
    QStringList kept;
    for (const QString& path : casePaths) {
        kept << pictureName(path);
    }
    QDir folder(folderName());
    for (const QString& name : folder.entryList({QStringLiteral("*.png")}, QDir::Files)) {
        if (!kept.contains(name)) {
            folder.remove(name);
        }
    }
}

QStringList recentCases()
{
    QStringList cases = settings::recentCases.read();
    const QStringList pinned = settings::pinnedCases.read();
    std::stable_partition(cases.begin(), cases.end(), [&pinned](const QString& path) { return pinned.contains(path); });
    return cases;
}

void rememberCase(const QString& path)
{
    if (isPrivate()) {
        return;
    }
    const QString absolute = QFileInfo(path).absoluteFilePath();
    const QStringList pinned = settings::pinnedCases.read();
    QStringList cases = settings::recentCases.read();
    cases.removeAll(absolute);
    cases.prepend(absolute);
    for (qsizetype i = cases.size(), left = cases.size() - keptCases - pinned.size(); i-- > 0 && left > 0;) {
        if (!pinned.contains(cases[i])) {
            cases.removeAt(i);
            --left;
        }
    }
    store(cases);
}

void forgetCase(const QString& path)
{
    setPinned(path, false);
    QStringList cases = settings::recentCases.read();
    cases.removeAll(path);
    store(cases);
}

void forgetRecentCases()
{
    const QStringList pinned = settings::pinnedCases.read();
    QStringList cases = settings::recentCases.read();
    cases.removeIf([&pinned](const QString& path) { return !pinned.contains(path); });
    settings::recentCases.write(cases);
    pruneCaseThumbnails(cases);
}

bool isPinned(const QString& path)
{
    return settings::pinnedCases.read().contains(path);
}

void setPinned(const QString& path, bool pinned)
{
    QStringList paths = settings::pinnedCases.read();
    paths.removeAll(path);
    if (pinned) {
        paths << path;
    }
    settings::pinnedCases.write(paths);
}

}   // namespace angiopose::app
