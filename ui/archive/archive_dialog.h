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

/// Dialog that selects a PACS, queries it and retrieves series. Passive view: displays the given state. Deletes itself
/// when closed.
class ArchiveDialog : public QDialog {
    Q_OBJECT
public:
    explicit ArchiveDialog(QWidget* parent);

    NodeBar& nodes() { return *nodes_; }
    SearchFields& fields() { return *fields_; }
    MatchList& list() { return *list_; }
    TransferLine& line() { return *transferStatus_; }
    CacheLine& cache() { return *cache_; }
    ReceiveLine& receive() { return *receive_; }

    void showState();   ///< enables the actions that are currently possible
    void offerPartialSeries(bool isOffered);   ///< offers to open the images of an incomplete retrieval

signals:
    void retrieveRequested();
    void partialSeriesRequested();

private:
    QLayout* makeButtons();

    NodeBar* nodes_;
    SearchFields* fields_;
    MatchList* list_;
    TransferLine* transferStatus_;
    CacheLine* cache_;
    ReceiveLine* receive_;
    QPushButton* partial_;
    QPushButton* retrieve_;
};

}   // namespace angiopose::ui
