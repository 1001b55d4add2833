#pragma once

#include "io/archive/dimse/link.h"
#include "io/archive/model/query.h"

#include <span>
#include <string_view>
#include <vector>

namespace angiopose::io {

namespace sop {
inline constexpr const char* verification = "1.2.840.10008.1.1";
inline constexpr const char* find = "1.2.840.10008.5.1.4.1.2.2.1";   // study root, as the next
inline constexpr const char* move = "1.2.840.10008.5.1.4.1.2.2.2";
inline constexpr const char* get = "1.2.840.10008.5.1.4.1.2.2.3";
inline constexpr std::string_view storagePrefix = "1.2.840.10008.5.1.4.1.1.";
}   // namespace sop

inline constexpr std::size_t maxContexts = 128;   ///< of an association

inline constexpr const char* implicitLittleEndian = "1.2.840.10008.1.2";

/// Encodings in which objects are taken as they are; the usual ones first.
std::span<const char* const> takenTransferSyntaxes();

/// Contexts to receive these objects by, each kind in each encoding, as far as an association has room (128, of which
/// `others` are taken). Where the kinds are not told: those of images and results that this program knows.
std::vector<ProposedContext> receivingContexts(const std::vector<ArchiveObject>& objects, std::size_t others);

}   // namespace angiopose::io
