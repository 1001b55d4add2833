#pragma once

#include "app/document/case_document.h"
#include "app/files/case_lookup.h"
#include "app/jobs/file_queue.h"

#include <QHash>
#include <QImage>
#include <QObject>

namespace angiopose::ui {
class WelcomePage;
class WindowActions;
}   // namespace angiopose::ui

namespace angiopose::app {

/// The cases opened or saved lately, on the first page and in the menu. What the disk knows of them comes later, from
/// threads of their own.
class RecentController : public QObject {
    Q_OBJECT
public:
    /// What of the window it serves.
    struct Ui {
        ui::WindowActions& actions;
        ui::WelcomePage& welcome;
    };
    RecentController(const CaseDocument& document, const Ui& ui, CaseLookup::Look look = lookAtCase,
                     QObject* parent = nullptr);

    void fill();   ///< the list anew, and a look at every case in it
    void pictureOpened();   ///< the case that was opened gets its picture

signals:
    void openRequested(const QString& path);

private:
    struct Known {
        CasePresence state = CasePresence::Present;
        QImage picture;
    };
    void show();
    void fillMenu(const QStringList& cases);
    void showNews();
    void take(const QString& path, const CaseLook& look);
    void clear();
    void setPictures(bool wanted);

    const CaseDocument& document_;
    Ui ui_;
    CaseLookup lookup_;
    FileQueue pictures_;
    QHash<QString, Known> known_;
    bool isNews_ = false;   ///< since the list was shown
};

}   // namespace angiopose::app
