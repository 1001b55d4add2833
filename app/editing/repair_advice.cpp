#include "app/editing/repair_advice.h"

#include <QtConcurrentRun>

namespace angiopose::app {

RepairAdvice::RepairAdvice(CaseDocument& document, QObject* parent) : QObject(parent), document_(document)
{
    connect(&document, &CaseDocument::changed, this, &RepairAdvice::followDocument);
    connect(&watcher_, &QFutureWatcherBase::finished, this, [this] {
        if (watcher_.future().resultCount() > 0) {
            found_ = watcher_.result();
            emit changed();
        }
    });
}

void RepairAdvice::followDocument()
{
    if (document_.current().vessels.tree == tree_) {
        return;
    }
    tree_ = document_.current().vessels.tree;
    found_ = {};
    watcher_.setFuture({});
    if (tree_) {
        watcher_.setFuture(QtConcurrent::run([tree = tree_] {
            return Found{core::pieceCount(*tree), core::findGaps(*tree)};
        }));
    }
    emit changed();
}

}   // namespace angiopose::app