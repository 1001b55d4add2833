#pragma once

#include "core/registration_case.h"

#include <QObject>
#include <QString>
#include <QUndoStack>

#include <memory>

namespace app {

/// Owns the open case. Views read `current()`; only undo commands write, and opening replaces it as a whole.
class CaseDocument : public QObject {
    Q_OBJECT
public:
    using QObject::QObject;

    const core::RegistrationCase& current() const { return case_; }
    QUndoStack& undoStack() { return undoStack_; }
    const QUndoStack& undoStack() const { return undoStack_; }
    bool isEmpty() const { return !case_.tree && !case_.angiogram; }
    bool isModified() const { return unsavedByNature_ || !undoStack_.isClean(); }
    const QString& path() const { return path_; }   ///< empty until saved or opened from a case file

    /// Another case takes the place of the open one. Without a path it counts as unsaved.
    void replace(core::RegistrationCase opened, const QString& path);
    void markSaved(const QString& path);
    void markUnsaved();   ///< e.g. recovered after a crash

    /// Applies an edit and remembers it for undo. While locked nothing happens but `editRefused`.
    bool push(std::unique_ptr<QUndoCommand> edit);
    void setLocked(bool locked);   ///< during a registration: its result must fit the case it started from
    bool isLocked() const { return locked_; }

signals:
    void changed();
    void stateChanged();   ///< path, saved state or lock
    void editRefused();

private:
    template <auto... Fields>
    friend class SetFields;

    core::RegistrationCase case_;
    QUndoStack undoStack_;
    QString path_;
    bool unsavedByNature_ = false;
    bool locked_ = false;
};

}   // namespace app
