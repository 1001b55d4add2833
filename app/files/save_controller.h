#pragma once

#include "app/document/case_document.h"
#include "app/files/autosave.h"
#include "app/files/export_controller.h"
#include "app/jobs/file_queue.h"

#include <QObject>

#include <functional>

class QWidget;

namespace angiopose::app {

/// Saves the open case, under its name or a new one, and offers what crashed sessions left behind.
class SaveController : public QObject {
    Q_OBJECT
public:
    SaveController(CaseDocument& document, ExportController& files, QWidget& window, QObject* parent = nullptr);

    /// What of the open case a file can hold: a case has vessels and an angiogram, vessels alone are centrelines.
    enum class Savable { Case, Vessels, Nothing };
    Savable savable() const;
    bool holdsWork() const;   ///< that no file has

    void save(const std::function<void()>& whenSaved = {});   ///< asks for a name where there is none
    void saveVessels(const std::function<void()>& whenSaved = {});   ///< as centrelines; asks for a name
    void saveAs(const std::function<void()>& whenSaved = {});
    /// Returns at once. Where the file was changed elsewhere since it was opened, the user is asked.
    void saveTo(const QString& path, const std::function<void()>& whenSaved = {},
                CaseKeeper::Replaced replaced = CaseKeeper::Replaced::KnownContent);
    bool isSaving() const { return files_.isBusy(); }
    void offerRecovery();
    void keepWork() { givenUp_.reset(); }   ///< what was to replace it could not be had
    void noteOpened(const QString& copy);   ///< another case is open; from a left copy, or not (empty)
    void autosaveSoon() { autosave_.saveSoon(); }
    void discardAutosave() { autosave_.discard(); }
    QString saveState() const;   ///< "Autosaved 12 s ago", "All changes saved", …

signals:
    void started();
    void failed(const QString& reason);
    void saved();
    void autosaveFailed(const QString& reason);   ///< it goes on trying
    void openElsewhere(const QString& words);   ///< the open case, in another window or program
    void reloadWanted(const QString& path);   ///< rather than write over what was changed elsewhere
    void recoveryWanted(const app::LeftBehind& copy);
    void vesselsRecovered(const QString& path);   ///< vessels without an angiogram; this is their file now

private:
    bool refusesToSave(const std::function<void()>& whenSaved);   ///< and says why, or offers what can be saved
    void offerVessels(const std::function<void()>& whenSaved);
    void askAboutChange(const QString& path, const std::function<void()>& whenSaved);
    void recover(const LeftBehind& copy);
    void forgetRecovered();
    void take(const QString& path, const CaseState& written);

    CaseDocument& document_;
    ExportController& export_;
    QWidget& window_;
    Autosave autosave_;
    FileQueue files_;
    CaseKeeper keeper_;
    std::optional<CaseState> keptVessels_;   ///< as which a file of centrelines has them
    std::optional<CaseState> givenUp_;   ///< the user rather wants what is in the file
    QString recoveredVessels_;   ///< where they lie
    std::optional<LeftBehind> wanted_;   ///< being opened
    std::optional<LeftBehind> recovered_;   ///< open; its copy goes once this session has its own
};

}   // namespace angiopose::app