#pragma once

#include <string>
#include <string_view>

namespace angiopose::io {

/// A new UID: the root 2.25, which everybody may use, and 128 random bits as a decimal number (a UUID, PS3.5 B.2).
std::string newUid();

/// The same with bits that follow from the content: equal content, equal UID; any other content, another one.
std::string uidOfContent(std::string_view content);

/// Numbers with dots between them, as the standard wants UIDs.
bool isUid(std::string_view text);

/// The UID that a file gives, or where that is none, one that follows from it: what it keeps together stays together.
std::string usableUid(const std::string& reported);

}   // namespace angiopose::io
