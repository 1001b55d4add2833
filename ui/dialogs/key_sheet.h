#pragma once

#include "ui/actions/fixed_shortcuts.h"

#include <QDialog>
#include <QKeySequence>

#include <vector>

class QAction;
class QLabel;
class QLineEdit;
class QTreeWidget;
class QTreeWidgetItem;

namespace angiopose::ui {

/// Lists all shortcuts; typing filters the list, and Enter on a line records a new shortcut. Reports conflicts but
/// never changes shortcuts itself. Deletes itself when closed.
class KeySheet : public QDialog {
    Q_OBJECT
public:
    KeySheet(std::vector<ShortcutRow> lines, QWidget* parent);

    void showRows(std::vector<ShortcutRow> lines);   ///< replaces the lines; keeps search text and selection
    bool isRecording() const { return recordedAction_ != nullptr; }

signals:
    void keyChosen(QAction* action, const QKeySequence& key);   ///< an empty key removes the shortcut
    void resetRequested();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void showMatching();
    void startRecording(QTreeWidgetItem* item);
    void stopRecording(const QString& word);
    void take(const QKeySequence& key);
    const ShortcutRow* rowOf(const QTreeWidgetItem* item) const;
    const ShortcutRow* conflictingRow(const QKeySequence& key) const;

    std::vector<ShortcutRow> rows_;
    QLineEdit* search_;
    QTreeWidget* list_;
    QLabel* status_;   ///< instruction, or outcome of the last assignment
    QAction* recordedAction_ = nullptr;
    QKeySequence warnedKey_;   ///< conflicting key that was pressed once, which only causes a warning
};

}   // namespace angiopose::ui
