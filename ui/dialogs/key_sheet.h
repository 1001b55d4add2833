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

/// All keys on one page; typing narrows them down, Enter on a line takes a new key for it. Knows which keys are taken,
/// changes nothing itself. Deletes itself when closed.
class KeySheet : public QDialog {
    Q_OBJECT
public:
    KeySheet(std::vector<KeyLine> lines, QWidget* parent);

    void showLines(std::vector<KeyLine> lines);   ///< keeps search and place
    bool isListening() const { return listening_ != nullptr; }

signals:
    void keyChosen(QAction* action, const QKeySequence& key);   ///< an empty key: none
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
    QLabel* word_;   ///< what to do, and what came of it
    QAction* listening_ = nullptr;
    QKeySequence warnedOf_;   ///< pressed once although another line has it
};

}   // namespace angiopose::ui