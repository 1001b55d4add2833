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

/// What is known of a case in the list of recent ones.
struct CaseLook {
    CasePresence state = CasePresence::Present;
    std::string picture;   ///< content of its picture's file; empty: none
};

/// Whether the file of a case and its inputs are there, and its picture.
CaseLook lookAtCase(const std::string& casePath, const std::string& picturePath);

/// Looks after cases on threads of their own, one for each folder: a drive that does not answer keeps neither the
/// window nor the others waiting, and nobody waits for such a thread when the program ends.
class CaseLookup : public QObject {
    Q_OBJECT
public:
    using Look = std::function<CaseLook(const std::string& casePath, const std::string& picturePath)>;
    explicit CaseLookup(Look look, QObject* parent = nullptr);
    ~CaseLookup() override;

    /// A case that is looked after already is looked after once more when that is done.
    void look(const QStringList& paths);

signals:
    void found(const QString& path, const CaseLook& look);
    void reported();   ///< for now all that was found

private:
    struct Shared;
    void publish();

    Look look_;
    std::shared_ptr<Shared> shared_;
    QTimer poll_;
};

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
