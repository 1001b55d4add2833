#pragma once

#include "app/files/open_controller.h"
#include "app/jobs/series_pictures.h"
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

/// Opens a folder or disc: lists its contents while they are found and opens the selection like any other files. A
/// folder with a single item that can be opened is opened without asking.
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

    void look(const QString& place);
    /// Lists several folders of series together under one name.
    void lookAtAll(const QStringList& folders, const QString& name);
    void abandon();
    bool isLooking() const { return job_.isRunning(); }

private:
    void begin(const QStringList& folders, const QString& name);
    void makeBrowser();
    void start(io::StudyReach reach);
    void leave();
    void follow(const io::StudyProgress& progress);
    void take(const SharedStudies& tree);
    void showTree(const SharedStudies& tree);
    QString placeFolder() const;
    void showEnd();
    void showBrowser();
    bool isBrowserShown() const;
    void wantPictures(const QStringList& keys);
    void open(const QString& vessels, const QStringList& views);
    const io::StudySeries* find(const QString& key) const;

    OpenController& open_;
    Notifications& notifications_;
    Ui ui_;
    QStringList folders_;   ///< one folder, or several listed together
    QString name_;   ///< display name of all folders
    SharedStudies tree_;
    QPointer<ui::StudyBrowser> browser_;
    io::StudyReach reach_ = io::StudyReach::Listed;
    bool isComplete_ = false;   ///< all files within reach have been read
    QElapsedTimer shown_;   ///< time since the list was rebuilt
    qint64 showingMs_ = 0;   ///< duration of the last rebuild
    QTimer patience_;   ///< shows the browser on timeout, whatever was found
    StudyJob job_;
    SeriesPictures pictures_;
};

}   // namespace angiopose::app
