#include "app/editing/repair_advice.h"

namespace angiopose::app {

RepairAdvice::RepairAdvice(CaseDocument& document, QObject* parent)
    : QObject(parent), document_(document), job_([this](const Found& found) {
          found_ = found;
          emit changed();
      })
{
    connect(&document, &CaseDocument::changed, this, &RepairAdvice::followDocument);
}

void RepairAdvice::followDocument()
{
    if (document_.current().vessels.tree == tree_) {
        return;
    }
    tree_ = document_.current().vessels.tree;
    found_ = {};
    job_.drop();
    if (tree_) {
        job_.start([tree = tree_](JobLink<double>&) -> core::Result<Found> {
            return Found{core::pieceCount(*tree), core::findGaps(*tree)};
        });
    }
    emit changed();
}

}   // namespace angiopose::app
