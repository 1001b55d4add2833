#pragma once

#include "core/support/result.h"

#include <string>
#include <string_view>
#include <vector>

namespace angiopose::io {

/// An archive that this program can query: a DICOM node, a DICOMweb address, or both. Holds only the file paths of keys
/// and passwords.
struct ArchiveNode {
    std::string name;   ///< display name
    std::string host;   ///< empty: DICOMweb only
    int port = 104;
    std::string title = "ANY-SCP";   ///< called AE title
    std::string ownTitle = "ANGIOPOSE";   ///< calling AE title
    int receivePort = 0;   ///< our port for objects retrieved by C-MOVE; 0: C-MOVE is not used
    bool isTls = false;
    std::string caFile;   ///< PEM; empty: the system's certificate authorities
    std::string certificateFile;   ///< our certificate, PEM; empty: none
    std::string keyFile;
    bool checksHost = true;   ///< whether the certificate must match `host`
    std::string webUrl;   ///< for example "https://pacs/dicom-web"
    std::string authorizationFile;   ///< file whose first line is sent as the Authorization header
    int answerSeconds = 9;   ///< timeout of one response, s
};

/// Whether a text is a valid AE title: 1 to 16 letters, digits or symbols other than the backslash (PS3.5 6.2).
bool isAeTitle(std::string_view title);

/// Returns "host:port".
std::string addressOf(const ArchiveNode& node);

/// Fails, naming the node, if its settings do not permit a connection attempt.
core::Status checkNode(const ArchiveNode& node);

/// Warnings about an unencrypted connection; empty if it is encrypted or stays on this computer.
core::Messages connectionNotes(const ArchiveNode& node);

}   // namespace angiopose::io
