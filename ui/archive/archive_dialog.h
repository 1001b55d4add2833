#pragma once

#include "ui/archive/archive_rows.h"

#include <QDialog>

class QLabel;
class QPushButton;

namespace angiopose::ui {

class CacheLine;
class MatchList;
class NodeBar;
class ReceiveLine;
class SearchFields;
class TransferLine;

/// Asks an archive: which one, what to look for, what to bring here. Shows what it is told; deletes itself when closed.
class ArchiveDialog : public QDialog {
    Q_OBJECT
public:
    explicit ArchiveDialog(QWidget* parent);

    NodeBar& nodes() { return *nodes_; }
    SearchFields& fields() { return *fields_; }
    MatchList& list() { return *list_; }
    TransferLine& line() { return *line_; }
    CacheLine& cache() { return *cache_; }
    ReceiveLine& receive() { return *receive_; }

    void showState();   ///< what can be done now
    void offerPart(bool isOffered);   ///< to open what came of a retrieval that did not end well

signals:
    void retrieveRequested();
    void partRequested();

private:
    QLayout* makeButtons();

    NodeBar* nodes_;
    SearchFields* fields_;
    MatchList* list_;
    TransferLine* line_;
    CacheLine* cache_;
    ReceiveLine* receive_;
    QPushButton* part_;
    QPushButton* retrieve_;
};

}   // namespace angiopose::ui
