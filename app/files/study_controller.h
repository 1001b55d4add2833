#pragma once

#include "app/files/open_controller.h"
#include "app/jobs/series_thumbnails.h"
#include "app/jobs/study_job.h"
#include "app/showing/notifications.h"

#include <QElapsedTimer>
#include <QObject>
#include <QPointer>
#include <QTimer>

class QAction;
class QWidget;

namespace angiopose::ui {
class BottomStrip;
class StudyBrowser;
}   // namespace angiopose::ui

namespace angiopose::app {

/// Opens a folder or disc: lists its contents as they are found and opens the user's selection like any other files. A
/// single item that can be opened is opened without asking.
class StudyController : public QObject {
    Q_OBJECT
public:
    /// Parts of the window that the controller uses.
    struct Ui {
        QAction& hideIdentity;
        ui::BottomStrip& strip;
        QWidget& dialogParent;
    };
    StudyController(OpenController& open, Notifications& notifications, const Ui& ui, QObject* parent = nullptr);

    void openFolder(const QString& place);
    /// Lists the series of several folders together under one name.
    void openFolders(const QStringList& folders, const QString& name);
    void abandon();
    bool isReading() const { return job_.isRunning(); }

private:
    void begin(const QStringList& folders, const QString& name);
    void createBrowser();
    void start(io::StudyScope scope);
    void stopReading();
    void follow(const io::StudyProgress& progress);
    void showResult(const SharedStudies& tree);
    void showTree(const SharedStudies& tree);
    QString placeFolder() const;
    void showSummary();
    void showBrowser();
    bool isBrowserShown() const;
    void requestThumbnails(const QStringList& keys);
    void open(const QString& vessels, const QStringList& views);
    const io::StudySeries* find(const QString& key) const;

    OpenController& openController_;
    Notifications& notifications_;
    Ui ui_;
    QStringList folders_;   ///< folder, or several folders that are listed together
    QString name_;   ///< common display name of the folders
    SharedStudies tree_;
    QPointer<ui::StudyBrowser> browser_;
    io::StudyScope scope_ = io::StudyScope::Listed;
    bool isComplete_ = false;   ///< true if all files within `scope_` have been read
    QElapsedTimer sinceRebuild_;   ///< time since the list was last rebuilt
    qint64 lastRebuildMs_ = 0;   ///< duration of the last rebuild
    QTimer showBrowserTimer_;   ///< on timeout, shows the browser with whatever was found so far
    StudyJob job_;
    SeriesThumbnails thumbnails_;
};

}   // namespace angiopose::app
