#include "io/support/lasting_text.h"

#include <mutex>
#include <set>

namespace angiopose::io {

std::string_view lasting(const std::string& text)
{
    static std::mutex mutex;
    static std::set<std::string> texts;   // whose nodes stay where they are
    const std::lock_guard lock(mutex);
    return *texts.insert(text).first;
}

}   // namespace angiopose::io
