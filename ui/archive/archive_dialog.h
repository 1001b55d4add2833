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

/// Queries an archive: selects the archive, searches it and retrieves series. Displays the values it is given; deletes
/// itself when closed.
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

    void showState();   ///< updates which actions are available
    void offerPart(bool isOffered);   ///< offers to open the result of an incomplete retrieval

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
