#include "app/editing/branch_words.h"

#include "ui/panels/result_sentences.h"

#include <QCoreApplication>

namespace angiopose::app {
namespace {

struct NameWords {
    Q_DECLARE_TR_FUNCTIONS(angiopose::app::BranchWords)
};

QString countWords(std::size_t count)
{
    return NameWords::tr("%1 branches").arg(count);
}

}   // namespace

ui::LocalizedText branchNames(const core::VesselTree& tree, const std::set<int>& branchIds)
{
    const core::VesselBranch* only = branchIds.size() == 1 ? tree.find(*branchIds.begin()) : nullptr;
    if (!only) {
        return [count = branchIds.size()] { return countWords(count); };
    }
    core::VesselBranch named;   // copy of the branch without its points
    named.id = only->id;
    named.name = only->name;
    return [named] { return ui::displayName(named); };
}

}   // namespace angiopose::app
