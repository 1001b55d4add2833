#pragma once

#include "app/document/case_document.h"
#include "app/jobs/file_queue.h"

#include <QHash>
#include <QImage>
#include <QObject>
#include <QStringList>
#include <QTimer>
#include <functional>
#include <memory>
#include <string>

namespace angiopose::ui {
class WelcomePage;
class WindowActions;
}   // namespace angiopose::ui

namespace angiopose::app {

enum class CasePresence { Present, Missing, InputsMissing };

/// State of a case in the list of recent cases.
struct RecentCaseStatus {
    CasePresence state = CasePresence::Present;
    std::string picture;   ///< contents of the thumbnail file; empty if there is none
};

/// Checks whether the case file and its inputs exist, and reads the thumbnail of the case.
RecentCaseStatus checkRecentCase(const std::string& casePath, const std::string& picturePath);

/// Checks cases on separate threads, one per folder, so that an unresponsive drive blocks neither the window nor the
/// other folders. The program does not wait for these threads when it exits.
class RecentCaseChecker : public QObject {
    Q_OBJECT
public:
    using CheckFunction = std::function<RecentCaseStatus(const std::string& casePath, const std::string& picturePath)>;
    explicit RecentCaseChecker(CheckFunction check, QObject* parent = nullptr);
    ~RecentCaseChecker() override;

    /// Checks the cases; if a check is already in progress for a case, checks that case again afterwards.
    void check(const QStringList& paths);

signals:
    void found(const QString& path, const RecentCaseStatus& check);
    void reported();   ///< emitted when all results so far have been reported

private:
    struct Shared;
    void publish();

    CheckFunction check_;
    std::shared_ptr<Shared> shared_;
    QTimer poll_;
};

/// Shows recently opened or saved cases on the welcome page and in the menu. Separate threads check the files and
/// update the list later.
class RecentController : public QObject {
    Q_OBJECT
public:
    /// Parts of the window that the controller uses.
    struct Ui {
        ui::WindowActions& actions;
        ui::WelcomePage& welcome;
    };
    RecentController(const CaseDocument& document, const Ui& ui,
                     RecentCaseChecker::CheckFunction check = checkRecentCase, QObject* parent = nullptr);

    void rebuild();   ///< rebuilds the list and starts a check of every case in it
    void makeThumbnail();   ///< creates the thumbnail of the case that was just opened

signals:
    void openRequested(const QString& path);

private:
    struct KnownCase {
        CasePresence state = CasePresence::Present;
        QImage picture;
    };
    void show();
    void fillMenu(const QStringList& cases);
    void showUpdates();
    void updateCase(const QString& path, const RecentCaseStatus& check);
    void clear();
    void setThumbnailsShown(bool enabled);

    const CaseDocument& document_;
    Ui ui_;
    RecentCaseChecker checker_;
    FileQueue thumbnails_;
    QHash<QString, KnownCase> knownCases_;
    bool hasUpdates_ = false;   ///< true if something has changed since the list was last shown
};

}   // namespace angiopose::app
