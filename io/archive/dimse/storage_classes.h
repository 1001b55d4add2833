#pragma once

#include "io/archive/dimse/link.h"
#include "io/archive/model/query.h"

#include <span>
#include <string_view>
#include <vector>

namespace angiopose::io {

namespace sop {
inline constexpr const char* verification = "1.2.840.10008.1.1";
inline constexpr const char* find = "1.2.840.10008.5.1.4.1.2.2.1";   // Study Root model, like the next two
inline constexpr const char* move = "1.2.840.10008.5.1.4.1.2.2.2";
inline constexpr const char* get = "1.2.840.10008.5.1.4.1.2.2.3";
inline constexpr std::string_view storagePrefix = "1.2.840.10008.5.1.4.1.1.";
}   // namespace sop

inline constexpr std::size_t maxContexts = 128;   ///< maximum number of presentation contexts per association

inline constexpr const char* implicitLittleEndian = "1.2.840.10008.1.2";

/// Returns the transfer syntaxes that we accept without transcoding, in order of preference.
std::span<const char* const> supportedTransferSyntaxes();

/// Returns the presentation contexts for receiving these objects: each SOP class in each transfer syntax, up to the
/// limit of an association (128, of which `others` are already in use). If no object specifies its SOP class, offers
/// all image and result classes that AngioPose supports.
std::vector<ProposedContext> storageContexts(const std::vector<ArchiveObject>& objects, std::size_t others);

}   // namespace angiopose::io
