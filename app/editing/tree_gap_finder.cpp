#include "app/editing/tree_gap_finder.h"

namespace angiopose::app {

TreeGapFinder::TreeGapFinder(CaseDocument& document, QObject* parent)
    : QObject(parent), document_(document), job_([this](const GapReport& found) {
          report_ = found;
          emit changed();
      })
{
    connect(&document, &CaseDocument::changed, this, &TreeGapFinder::updateFromDocument);
}

void TreeGapFinder::updateFromDocument()
{
    if (document_.current().vessels.tree == tree_) {
        return;
    }
    tree_ = document_.current().vessels.tree;
    report_ = {};
    job_.drop();
    if (tree_) {
        job_.start([tree = tree_](JobLink<double>&) -> core::Result<GapReport> {
            return GapReport{core::componentCount(*tree), core::findGaps(*tree)};
        });
    }
    emit changed();
}

}   // namespace angiopose::app
