#include "io/case/stale_results.h"

#include "core/registration/deformable/bent_tree.h"
#include "io/messages/says.h"

#include <optional>
#include <utility>

namespace angiopose::io {
namespace {

/// A file that nobody vouches for is another one.
bool isAsNoted(const core::InputFile& noted, const core::InputFile& read)
{
    return noted.path.empty() || (!noted.sha256.empty() && noted.sha256 == read.sha256);
}

bool areAsNoted(const core::Vessels& noted, const core::Vessels& read)
{
    return isAsNoted(noted.file, read.file) && isAsNoted(noted.scanFile, read.scanFile) &&
           noted.excludedBranchIds == read.excludedBranchIds;
}

/// A view of another case file was found with the vessels of that one.
bool isAsNoted(const core::View& noted, const core::View& read)
{
    return noted.caseFile.path.empty() && isAsNoted(noted.imageFile, read.imageFile) &&
           isAsNoted(noted.target.file, read.target.file);
}

/// Bent vessels of another tree would be drawn where none are.
bool isOfTree(const core::View& view, const core::Vessels& vessels)
{
    const core::DeformableResult* const bent = view.result ? view.result->bent.get() : nullptr;
    return !bent || !vessels.tree || core::isOf(*vessels.tree, *bent);
}

/// Why the result of a view does not count any more, if it does not.
std::optional<core::Message> whyStale(const core::View& noted, const ViewNotes& notes, const core::View& read,
                                      bool haveVesselsChanged)
{
    if (haveVesselsChanged || !isAsNoted(noted, read)) {
        return says::caseResultStale();
    }
    if (!notes.changedBesideResult.empty()) {
        return says::caseResultBeside(notes.changedBesideResult);
    }
    return {};
}

}   // namespace

void dropStaleResults(const core::Case& noted, std::span<const ViewNotes> notes, core::Case& read,
                      core::Messages& warnings)
{
    const bool areVesselsNoted = areAsNoted(noted.vessels, read.vessels);
    for (std::size_t k = 0; k < read.views.size(); ++k) {
        core::View& view = read.views[k];
        const bool haveVesselsChanged = !areVesselsNoted || !isOfTree(view, read.vessels);
        const auto why = whyStale(noted.views[k], notes[k], view, haveVesselsChanged);
        if (why && std::exchange(view.result, std::nullopt) && noted.views[k].caseFile.path.empty()) {
            warnings.push_back(why->about(view.imageFile.path));
        }
    }
}

}   // namespace angiopose::io
