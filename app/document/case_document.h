#pragma once

#include "core/case/case.h"

#include <QObject>
#include <QString>
#include <QUndoStack>

#include <cstdint>
#include <memory>

namespace angiopose::app {

/// Which case was open, and how far it had been edited, at some moment.
struct CaseState {
    int caseNumber = 0;
    std::uint64_t revision = 0;

    bool operator==(const CaseState&) const = default;
};

/// Owns the open case. Views read `current()`; only undo commands write, and opening replaces it as a whole.
class CaseDocument : public QObject {
    Q_OBJECT
public:
    explicit CaseDocument(QObject* parent = nullptr);

    const core::Case& current() const { return case_; }
    QUndoStack& undoStack() { return undoStack_; }
    const QUndoStack& undoStack() const { return undoStack_; }
    bool isEmpty() const { return !case_.vessels.tree && !case_.shown().angiogram; }
    bool isModified() const { return unsavedByNature_ || !undoStack_.isClean(); }
    /// Something would be lost with it: edits, or a copy of a crashed session. Opening files alone is no work.
    bool holdsWork() const { return isModified() && (isRecovered_ || !undoStack_.isClean()); }
    const QString& path() const { return path_; }   ///< empty until saved or opened from a case file

    /// Another case takes the place of the open one. Without a path it counts as unsaved.
    void replace(core::Case opened, const QString& path);
    CaseState state() const { return {caseNumber_, revision_}; }

    /// The case as it was at `written` now lies in a file; edits made since then stay unsaved.
    void markSaved(const QString& path, const CaseState& written);
    void markUnsaved();   ///< e.g. recovered after a crash

    /// Applies an edit and remembers it for undo. While locked nothing happens but `editRefused`.
    bool push(std::unique_ptr<QUndoCommand> edit);
    void setLocked(bool locked);   ///< during a registration: its result must fit the case it started from
    bool isLocked() const { return locked_; }

    /// Steps of undo by the user; never back behind the start of a trial.
    void undo();
    void redo();
    bool canUndo() const { return undoStack_.index() > undoFloor_ && undoStack_.canUndo(); }

    /// A blind trial begins with this edit; ending it takes that edit and all since back, for good.
    void beginTrial(std::unique_ptr<QUndoCommand> edit);
    void endTrial();
    bool isInTrial() const { return undoFloor_ > 0; }
    int trialEdits() const { return undoStack_.index() - undoFloor_; }   ///< steps of undo since it began

    void noteChange() { emit changed(); }   ///< of what belongs to the case though it is not in it, as a mask's draft

signals:
    void aboutToStep();   ///< undo or redo is next: what is under way under the mouse ends first
    void changed();
    void stateChanged();   ///< path, saved state or lock
    void editRefused();

private:
    template <auto... Fields>
    friend class SetFields;

    core::Case case_;
    QUndoStack undoStack_;
    QString path_;
    int caseNumber_ = 0;   ///< counts the cases opened
    std::uint64_t revision_ = 0;   ///< counts the changes
    bool unsavedByNature_ = false;
    bool isRecovered_ = false;   ///< and not saved since
    bool locked_ = false;
    int undoFloor_ = 0;   ///< of the running trial; 0: no trial
};

}   // namespace angiopose::app