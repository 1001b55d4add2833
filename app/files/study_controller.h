#pragma once

#include "app/files/open_controller.h"
#include "app/jobs/series_pictures.h"
#include "app/jobs/study_job.h"
#include "app/showing/notices.h"

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

/// A folder or disc that is opened: what lies in it is listed while it is found, and what is chosen goes the way of all
/// files. A folder with one thing that can be opened is opened without asking.
class StudyController : public QObject {
    Q_OBJECT
public:
    /// What of the window it serves.
    struct Ui {
        QAction& hideIdentity;
        ui::BottomStrip& strip;
        QWidget& dialogParent;
    };
    StudyController(OpenController& open, Notices& notices, const Ui& ui, QObject* parent = nullptr);

    void look(const QString& place);
    /// Folders of series, together one place of that name.
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
    Notices& notices_;
    Ui ui_;
    QStringList folders_;   ///< one, or those that are looked at together
    QString name_;   ///< of all of them, for the user
    SharedStudies tree_;
    QPointer<ui::StudyBrowser> browser_;
    io::StudyReach reach_ = io::StudyReach::Listed;
    bool isComplete_ = false;   ///< all files of the reach are read
    QElapsedTimer shown_;   ///< since the list was made anew
    qint64 showingMs_ = 0;   ///< that took
    QTimer patience_;   ///< the browser is shown when it ends, whatever was found
    StudyJob job_;
    SeriesPictures pictures_;
};

}   // namespace angiopose::app
