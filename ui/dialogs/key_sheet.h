#pragma once

#include "ui/actions/key_notes.h"

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
    KeySheet(std::vector<KeyLine> lines, QWidget* parent);

    void showLines(std::vector<KeyLine> lines);   ///< replaces the lines; keeps search text and selection
    bool isListening() const { return listening_ != nullptr; }

signals:
    void keyChosen(QAction* action, const QKeySequence& key);   ///< an empty key removes the shortcut
    void resetRequested();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void showMatching();
    void listenFor(QTreeWidgetItem* item);
    void stopListening(const QString& word);
    void take(const QKeySequence& key);
    const KeyLine* lineOf(const QTreeWidgetItem* item) const;
    const KeyLine* takenBy(const QKeySequence& key) const;

    std::vector<KeyLine> lines_;
    QLineEdit* search_;
    QTreeWidget* list_;
    QLabel* word_;   ///< instruction, or outcome of the last assignment
    QAction* listening_ = nullptr;
    QKeySequence warnedOf_;   ///< conflicting key after its first press, which only warns
};

}   // namespace angiopose::ui
