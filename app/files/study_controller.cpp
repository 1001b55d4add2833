#include "app/files/study_controller.h"

#include "app/files/study_rows.h"
#include "io/messages/messages.h"
#include "ui/dialogs/study_browser.h"
#include "ui/dialogs/study_list.h"
#include "ui/panels/bottom_strip.h"
#include "ui/words/language.h"
#include "ui/words/message_text.h"

#include <QAction>
#include <QDir>
#include <QFileInfo>
#include <QLocale>

#include <algorithm>

namespace angiopose::app {
namespace {

constexpr int showBrowserDelayMs = 700;   // time in which a folder with one series is read and opened without a list
constexpr int restShare = 10;   // minimum pause between list updates, as a multiple of the duration of an update
constexpr int picturePx = 2 * ui::StudyList::thumbnailSize;   // high enough for 200 % display scaling

std::vector<const io::StudySeries*> usableOf(const io::StudyTree& tree)
{
    std::vector<const io::StudySeries*> usable;
    for (const io::StudyPatient& patient : tree.patients) {
        for (const io::Study& study : patient.studies) {
            for (const io::StudySeries& series : study.series) {
                if (series.use != io::SeriesUse::None) {
                    usable.push_back(&series);
                }
            }
        }
    }
    return usable;
}

QImage imageOf(const core::ImageF& picture)
{
    QImage image(picture.width, picture.height, QImage::Format_Grayscale8);
    for (int y = 0; y < picture.height; ++y) {
        for (int x = 0; x < picture.width; ++x) {
            image.scanLine(y)[x] = static_cast<uchar>(std::clamp(255.0F * picture.at(x, y), 0.0F, 255.0F));
        }
    }
    return image;
}

}   // namespace

StudyController::StudyController(OpenController& open, Notifications& notifications, const Ui& ui, QObject* parent)
    : QObject(parent), openController_(open), notifications_(notifications), ui_(ui), thumbnails_(picturePx, this)
{
    showBrowserTimer_.setSingleShot(true);
    showBrowserTimer_.setInterval(showBrowserDelayMs);
    connect(&showBrowserTimer_, &QTimer::timeout, this, &StudyController::showBrowser);
    connect(&openController_, &OpenController::studyOffered, this, &StudyController::openFolder);
    connect(&job_, &StudyJob::progressed, this, &StudyController::follow);
    connect(&job_, &StudyJob::finished, this, &StudyController::showResult);
    connect(&job_, &StudyJob::failed, this, [this](const core::Message& reason) {
        ui_.strip.showIdle(tr("Ready"));
        abandon();
        notifications_.showProblem(tr("The folder could not be opened"), ui::messageText(reason), folders_);
    });
    connect(&ui_.hideIdentity, &QAction::toggled, this, [this] {
        if (browser_ && tree_) {
            showTree(tree_);
        }
    });
    connect(&thumbnails_, &SeriesThumbnails::loaded, this, [this](const QString& key, const core::ImageF& picture) {
        if (browser_) {
            browser_->showThumbnail(key, imageOf(picture));
        }
    });
    connect(&thumbnails_, &SeriesThumbnails::failed, this, [this](const QString& key) {
        if (browser_) {
            browser_->showThumbnail(key, {});
        }
    });
}

void StudyController::openFolder(const QString& place)
{
    begin({place}, QDir::toNativeSeparators(place));
}

void StudyController::openFolders(const QStringList& folders, const QString& name)
{
    begin(folders, name);
}

void StudyController::begin(const QStringList& folders, const QString& name)
{
    abandon();
    folders_ = folders;
    name_ = name;
    tree_.reset();
    createBrowser();
    showBrowserTimer_.start();
    start(io::StudyScope::Listed);
}

void StudyController::createBrowser()
{
    browser_ = new ui::StudyBrowser(name_, &ui_.dialogParent);
    browser_->addAction(&ui_.hideIdentity);
    connect(browser_, &ui::StudyBrowser::stopRequested, &job_, &StudyJob::requestStop);
    connect(browser_, &ui::StudyBrowser::allFilesRequested, this, [this] { start(io::StudyScope::AllFiles); });
    connect(browser_, &ui::StudyBrowser::thumbnailsRequested, this, &StudyController::requestThumbnails);
    connect(browser_, &ui::StudyBrowser::seriesChosen, this, &StudyController::open);
    connect(browser_, &QDialog::finished, this, &StudyController::stopReading);
}

void StudyController::start(io::StudyScope scope)
{
    isComplete_ = false;
    scope_ = scope;
    browser_->showProgress(0, 0);
    ui_.strip.showBusy(tr("Searching %1…").arg(QFileInfo(name_).fileName()));
    job_.start(folders_, scope);
}

/// Stops reading the folder and the thumbnails.
void StudyController::stopReading()
{
    showBrowserTimer_.stop();
    thumbnails_.request({});
    if (job_.isRunning()) {
        job_.abandon();
        ui_.strip.showIdle(tr("Ready"));
    }
}

void StudyController::abandon()
{
    stopReading();
    if (browser_) {
        browser_->disconnect(this);
        browser_->hide();
        browser_->deleteLater();
        browser_ = nullptr;
    }
}

void StudyController::follow(const io::StudyProgress& progress)
{
    if (!browser_) {
        return;
    }
    browser_->showProgress(static_cast<qsizetype>(progress.read), static_cast<qsizetype>(progress.found));
    const bool isDue = !sinceRebuild_.isValid() ||
                       sinceRebuild_.elapsed() > restShare * lastRebuildMs_;   // updates long lists less often
    if (progress.tree && progress.tree != tree_ && scope_ == io::StudyScope::Listed && isDue) {
        QElapsedTimer took;
        took.start();
        showTree(progress.tree);
        lastRebuildMs_ = took.elapsed();
        sinceRebuild_.start();
        if (usableOf(*tree_).size() > 1) {
            showBrowser();
        }
    }
}

void StudyController::showResult(const SharedStudies& tree)
{
    if (!browser_) {
        return;
    }
    showBrowserTimer_.stop();
    ui_.strip.showIdle(tr("Ready"));
    isComplete_ = !tree->isStopped;
    showTree(tree);
    const auto usable = usableOf(*tree);
    const auto& directory = tree->directory;
    const bool isAsListed = !directory || (directory->unlistedFiles == 0 && directory->missingFiles == 0);
    const bool isAllRead = !tree->isStopped && !tree->isTruncated && tree->damagedFiles.empty() && isAsListed;
    if (tree->patients.empty() && !isBrowserShown()) {
        abandon();
        notifications_.showProblem(tr("The folder could not be opened"),
                                   ui::messageText(io::messages::seriesNone().about(name_.toStdString())), folders_);
        return;
    }
    if (usable.size() == 1 && isAllRead && !isBrowserShown()) {
        const io::StudySeries only = *usable.front();
        abandon();
        const bool isRun = only.use == io::SeriesUse::View;
        const bool isFolder = tree->directory == std::nullopt && folders_.size() == 1;
        openController_.openStudy({isRun      ? QString()
                                   : isFolder ? folders_.front()
                                              : QString::fromStdString(only.place),
                                   QString::fromStdString(only.series.id),
                                   isRun ? QStringList{QString::fromStdString(only.place)} : QStringList()});
        return;
    }
    showSummary();
    if (usable.size() == 1) {
        browser_->choose(keyOf(*usable.front()));
    }
    showBrowser();
}

void StudyController::showTree(const SharedStudies& tree)
{
    tree_ = tree;
    browser_->showRows(studyRows(*tree, ui_.hideIdentity.isChecked() ? IdentityShown::No : IdentityShown::Yes,
                                 isComplete_ ? Numbering::Final : Numbering::Provisional));
}

/// Reports the number of files read, and which files are damaged, or listed in the DICOMDIR but missing.
void StudyController::showSummary()
{
    const QLocale locale;
    const auto read = locale.toString(static_cast<qulonglong>(tree_->readFiles));
    const auto found = locale.toString(static_cast<qulonglong>(tree_->foundFiles));
    QStringList words{tree_->isStopped ? tr("Stopped after %1 of %2 files.").arg(read, found)
                                       : tr("%1 files read.").arg(read)};
    if (tree_->isTruncated) {
        words << tr("The folder contains too many files to list. Choose the folder of a single study.");
    }
    QString offer;
    if (const auto& directory = tree_->directory; directory && directory->damage) {
        words << tr("The DICOMDIR is unusable (%1); the files were read directly.")
                     .arg(ui::messageText(directory->damage));
    } else if (directory) {
        if (directory->missingFiles > 0) {
            words << tr("Files listed in the DICOMDIR but missing: %1.").arg(directory->missingFiles);
        }
        if (directory->unlistedFiles > 0) {
            offer = directory->unlistedFiles == 1
                        ? tr("The DICOMDIR lists %1 series; 1 more file is not listed.").arg(directory->series)
                        : tr("The DICOMDIR lists %1 series; %2 more files are not listed.")
                              .arg(directory->series)
                              .arg(directory->unlistedFiles);
        }
    }
    QStringList damagedFiles;
    for (const io::DamagedFile& file : tree_->damagedFiles) {
        damagedFiles << QStringLiteral("%1: %2").arg(QString::fromStdString(file.path), ui::messageText(file.reason));
    }
    browser_->showEnd(words.join(u' '), damagedFiles, offer);
}

void StudyController::showBrowser()
{
    showBrowserTimer_.stop();
    if (browser_ && !browser_->isVisible()) {
        browser_->open();
    }
}

bool StudyController::isBrowserShown() const
{
    return browser_ && browser_->isVisible();
}

QString StudyController::placeFolder() const
{
    const QFileInfo place(folders_.front());
    return place.isDir() ? folders_.front() : place.absolutePath();
}

const io::StudySeries* StudyController::find(const QString& key) const
{
    for (const io::StudyPatient& patient : tree_->patients) {
        for (const io::Study& study : patient.studies) {
            const auto found = std::ranges::find(study.series, key, keyOf);
            if (found != study.series.end()) {
                return &*found;
            }
        }
    }
    return nullptr;
}

void StudyController::requestThumbnails(const QStringList& keys)
{
    std::deque<SeriesThumbnails::Request> wanted;
    for (const QString& key : keys) {
        if (const io::StudySeries* series = find(key)) {
            wanted.push_back({key, {tree_, &series->series}});
        }
    }
    thumbnails_.request(std::move(wanted));
}

void StudyController::open(const QString& vessels, const QStringList& views)
{
    StudyChoice choice;
    if (const io::StudySeries* series = find(vessels)) {
        // If not all files have been read, other slices of the series may be anywhere below the opened folder.
        choice.folder = isComplete_ || folders_.size() > 1 ? QString::fromStdString(series->place) : placeFolder();
        choice.seriesId = QString::fromStdString(series->series.id);
    }
    for (const QString& key : views) {
        if (const io::StudySeries* series = find(key)) {
            choice.runs << QString::fromStdString(series->place);
        }
    }
    stopReading();
    openController_.openStudy(choice);
}

}   // namespace angiopose::app
