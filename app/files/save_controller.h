#pragma once

#include "app/document/case_document.h"
#include "app/files/autosave.h"
#include "app/files/export_controller.h"
#include "app/jobs/file_queue.h"

#include <QObject>

#include <functional>

class QWidget;

namespace angiopose::app {

/// Saves the open case under its current or a new name, and offers to recover copies left by crashed sessions.
class SaveController : public QObject {
    Q_OBJECT
public:
    SaveController(CaseDocument& document, ExportController& files, QWidget& window, QObject* parent = nullptr);

    /// Part of the open case that can be saved: a case (vessels and an angiogram), or vessels alone as centerlines.
    enum class Savable { Case, Vessels, Nothing };
    Savable savable() const;
    bool hasUnsavedWork() const;   ///< true if there is work that is in no file

    void save(const std::function<void()>& whenSaved = {});   ///< saves the case; asks for a name if the case has none
    void saveVessels(const std::function<void()>& whenSaved = {});   ///< saves centerlines; asks for a name
    void saveAs(const std::function<void()>& whenSaved = {});
    /// Saves in the background. Asks the user if the file was changed elsewhere since it was opened.
    void saveTo(const QString& path, const std::function<void()>& whenSaved = {},
                CaseFileGuard::Overwrite replaced = CaseFileGuard::Overwrite::KnownContent);
    bool isSaving() const { return files_.isBusy(); }
    void offerRecovery();
    void retainWork() { discardedState_.reset(); }   ///< call if the file that was to replace the case was not opened
    void noteOpened(const QString& copy);   ///< call after opening another case; `copy` is the recovered copy, or empty
    void autosaveSoon() { autosave_.saveSoon(); }
    void discardAutosave() { autosave_.discard(); }
    QString saveState() const;   ///< returns e.g. "Autosaved 12 s ago" or "All changes saved"

signals:
    void started();
    void failed(const QString& reason);
    void saved();
    void autosaveFailed(const QString& reason);   ///< emitted when autosave fails; autosave keeps trying
    void foundOpenElsewhere(
        const QString& note);   ///< emitted if the open case is also open in another window or program
    void reloadRequested(const QString& path);   ///< emitted to load changes made elsewhere instead of overwriting them
    void recoveryRequested(const app::RecoveryCopy& copy);
    void vesselsRecovered(const QString& path);   ///< emitted with the file of recovered vessels without an angiogram

private:
    bool reportSaveProblem(
        const std::function<void()>& whenSaved);   ///< if so, states the reason or offers to save a part
    void offerToSaveVessels(const std::function<void()>& whenSaved);
    void confirmOverwrite(const QString& path, const std::function<void()>& whenSaved);
    void recover(const RecoveryCopy& copy);
    void forgetRecovered();
    void finishSave(const QString& path, const CaseState& written);

    CaseDocument& document_;
    ExportController& exportController_;
    QWidget& window_;
    Autosave autosave_;
    FileQueue files_;
    CaseFileGuard fileGuard_;
    std::optional<CaseState> savedVesselsState_;   ///< state of the case last saved as a centerline file
    std::optional<CaseState> discardedState_;   ///< state that the user agreed to discard in favor of the saved file
    QString recoveredVessels_;   ///< path of the recovered vessels
    std::optional<RecoveryCopy> requestedCopy_;   ///< recovered copy that is being opened
    std::optional<RecoveryCopy> recoveredCopy_;   ///< recovered copy that is open; removed after the next autosave
};

}   // namespace angiopose::app
