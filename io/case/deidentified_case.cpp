#include "io/case/deidentified_case.h"

#include <filesystem>
#include <string>

namespace angiopose::io {
namespace {

/// Removes user-entered text and counts the removed strings.
class TextRemover {
public:
    void operator()(std::string& text, const std::string& instead = {})
    {
        count_ += text.empty() ? 0 : 1;
        text = text.empty() ? std::string() : instead;
    }

    std::size_t count() const { return count_; }

private:
    std::size_t count_ = 0;
};

/// Converts an index to its 1-based number as text: 0 becomes "1".
std::string place(std::size_t index)
{
    return std::to_string(index + 1);
}

template <class Named>
void numberNames(std::vector<Named>& named, TextRemover& erase)
{
    for (std::size_t n = 0; n < named.size(); ++n) {
        erase(named[n].name, place(n));
        erase(named[n].extraKeys);
    }
}

void clearSnapshot(core::PoseSnapshot& snapshot, std::size_t index, TextRemover& erase)
{
    erase(snapshot.name, place(index));
    erase(snapshot.author);
    erase(snapshot.note);
    snapshot.time.clear();
    erase(snapshot.extraKeys);
}

void clearView(core::View& view, TextRemover& erase)
{
    erase(view.name);
    erase(view.extraKeys);
    numberNames(view.landmarks, erase);
    numberNames(view.measurements, erase);
    for (std::size_t n = 0; n < view.annotations.size(); ++n) {
        erase(view.annotations[n].text, place(n));
        erase(view.annotations[n].extraKeys);
    }
    for (std::size_t n = 0; n < view.snapshots.size(); ++n) {
        clearSnapshot(view.snapshots[n], n, erase);
    }
    if (view.result) {
        erase(view.result->provenance.author);
        view.result->provenance.time.clear();
    }
}

/// Replaces the file name by a neutral one, for example "angiogram.dcm"; a folder gets `word` without an extension.
void replaceFileName(core::InputFile& file, const std::string& word)
{
    if (!file.path.empty()) {
        const std::filesystem::path path(file.path);
        file.path = (path.parent_path() / word).string() + path.extension().string();
    }
}

}   // namespace

std::size_t removeFreeText(core::Case& session)
{
    TextRemover erase;
    erase(session.title);
    erase(session.extraKeys);
    numberNames(session.vessels.marks, erase);
    numberNames(session.vessels.measurements, erase);
    for (core::View& view : session.views) {
        clearView(view, erase);
    }
    return erase.count();
}

core::Case deidentifyCase(core::Case session)
{
    removeFreeText(session);
    replaceFileName(session.vessels.file, "vessels");
    replaceFileName(session.vessels.scanFile, "scan");
    for (core::View& view : session.views) {
        replaceFileName(view.imageFile, "angiogram");
        replaceFileName(view.target.file, "curves");
    }
    return session;
}

}   // namespace angiopose::io
