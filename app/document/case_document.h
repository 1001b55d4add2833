#pragma once

#include "core/case/case.h"

#include <QObject>
#include <QString>
#include <QUndoStack>

#include <cstdint>
#include <memory>

namespace angiopose::app {

/// Identifies the open case and its revision at a point in time.
struct CaseState {
    int caseNumber = 0;
    std::uint64_t revision = 0;

    bool operator==(const CaseState&) const = default;
};

/// Owns the open case. Views read `current()`; only undo commands modify it, and opening replaces it completely.
class CaseDocument : public QObject {
    Q_OBJECT
public:
    explicit CaseDocument(QObject* parent = nullptr);

    const core::Case& current() const { return case_; }
    QUndoStack& undoStack() { return undoStack_; }
    const QUndoStack& undoStack() const { return undoStack_; }
    bool isEmpty() const { return !case_.vessels.tree && !case_.shown().angiogram; }
    bool isModified() const { return isNeverSaved_ || !undoStack_.isClean(); }
    /// Returns whether closing would lose work: unsaved edits, or a copy recovered after a crash. Opening files alone
    /// does not count as work.
    bool hasUnsavedWork() const { return isModified() && (isRecovered_ || !undoStack_.isClean()); }
    const QString& path() const { return path_; }   ///< empty until saved or opened from a case file

    /// Replaces the open case. Without a path, the new case counts as unsaved.
    void replace(core::Case opened, const QString& path);
    CaseState state() const { return {caseNumber_, revision_}; }

    /// Marks the state `written` as saved to `path`; edits made since remain unsaved.
    void markSaved(const QString& path, const CaseState& written);
    void markUnsaved();   ///< marks the case as unsaved, e.g. after recovery from a crash

    /// Applies an edit and adds it to the undo stack. While the document is locked, only emits `editRefused`.
    bool push(std::unique_ptr<QUndoCommand> edit);
    void setLocked(bool locked);   ///< used during registration, whose result must fit the case from which it started
    bool isLocked() const { return locked_; }

    /// Undo and redo an edit of the user; undo stops at the start of a blind trial.
    void undo();
    void redo();
    bool canUndo() const { return undoStack_.index() > trialStartIndex_ && undoStack_.canUndo(); }

    /// Starts a blind trial with this edit. `endTrial` permanently reverts this edit and all later ones.
    void beginTrial(std::unique_ptr<QUndoCommand> edit);
    void endTrial();
    bool isInTrial() const { return trialStartIndex_ > 0; }
    int trialEdits() const { return undoStack_.index() - trialStartIndex_; }   ///< number of undo steps since the start

    void notifyChanged() { emit changed(); }   ///< for data that belong to the case but are outside it, e.g. a mask

signals:
    void aboutToUndoOrRedo();   ///< emitted before undo or redo; receivers finish any mouse interaction
    void changed();
    void stateChanged();   ///< emitted when the path, the saved state or the lock has changed
    void editRefused();

private:
    template <auto... Fields>
    friend class SetFields;

    core::Case case_;
    QUndoStack undoStack_;
    QString path_;
    int caseNumber_ = 0;   ///< number of cases opened
    std::uint64_t revision_ = 0;   ///< number of changes
    bool isNeverSaved_ = false;
    bool isRecovered_ = false;   ///< true if the case was recovered after a crash and not saved since
    bool locked_ = false;
    int trialStartIndex_ = 0;   ///< undo index at which the current trial began; 0 if there is no trial
};

}   // namespace angiopose::app
