#include "io/case/input_facts.h"

#include "io/file_hash.h"

#include <algorithm>
#include <filesystem>

namespace angiopose::io {
namespace {

namespace fs = std::filesystem;

void addFile(InputFacts& facts, const fs::path& file)
{
    std::error_code failed;
    const auto size = fs::file_size(file, failed);
    const auto modified = fs::last_write_time(file, failed);
    if (!failed) {
        facts.size += size;
        facts.modified =
            std::max<std::int64_t>(facts.modified, static_cast<std::int64_t>(modified.time_since_epoch().count()));
    }
}

}   // namespace

InputFacts factsOfInput(const std::string& path, const std::string& sha256)
{
    InputFacts facts;
    facts.path = path;
    facts.sha256 = sha256;
    facts.modified = std::numeric_limits<std::int64_t>::min();
    std::error_code failed;
    facts.isThere = fs::exists(path, failed);
    if (fs::is_directory(path, failed)) {
        for (const auto& entry : fs::directory_iterator(path, failed)) {
            addFile(facts, entry.path());
        }
    } else if (facts.isThere) {
        addFile(facts, path);
    }
    return facts;
}

bool isUnchanged(const InputFacts& known)
{
    const InputFacts now = factsOfInput(known.path, known.sha256);
    if (now == known) {
        return true;
    }
    if (now.isThere != known.isThere || now.size != known.size || known.sha256.empty()) {
        return false;
    }
    const auto content = sha256OfFile(known.path);
    return content && content.value() == known.sha256;
}

}   // namespace angiopose::io
