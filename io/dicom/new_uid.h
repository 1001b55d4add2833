#pragma once

#include <string>
#include <string_view>

namespace angiopose::io {

/// Creates a UID from the root 2.25, which anyone may use, and 128 random bits as a decimal number (a UUID, PS3.5 B.2).
std::string makeUid();

/// Creates a UID of the same form from a hash of the content: equal contents have equal UIDs, different contents have
/// different UIDs.
std::string uidFromContent(std::string_view content);

/// Returns whether `text` is a valid UID: numbers separated by dots.
bool isUid(std::string_view text);

/// Returns the UID of a file, or a valid one derived from it if it is invalid; equal invalid UIDs give equal results.
std::string validUid(const std::string& uid);

}   // namespace angiopose::io
