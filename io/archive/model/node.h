#pragma once

#include "core/support/result.h"

#include <string>
#include <string_view>
#include <vector>

namespace angiopose::io {

/// Archive that AngioPose can query: a DICOM node, a DICOMweb service, or both. Stores only the paths of key and
/// password files, not their contents.
struct ArchiveNode {
    std::string name;   ///< display name
    std::string host;   ///< if empty, the node supports DICOMweb only
    int port = 104;
    std::string title = "ANY-SCP";   ///< called AE title
    std::string ownAeTitle = "ANGIOPOSE";   ///< calling AE title
    int receivePort = 0;   ///< our port for objects retrieved by C-MOVE; 0 disables C-MOVE
    bool isTls = false;
    std::string caFile;   ///< PEM file; if empty, the system's certificate authorities
    std::string certificateFile;   ///< our certificate, PEM file (optional)
    std::string keyFile;
    bool verifiesHost = true;   ///< whether the server certificate must match `host`
    std::string webUrl;   ///< base URL, for example "https://pacs/dicom-web"
    std::string authorizationFile;   ///< file whose first line is sent as the HTTP Authorization header
    int responseTimeoutSeconds = 9;   ///< timeout for one response, s
};

/// Returns whether `title` is a valid AE title: 1 to 16 letters, digits or symbols except backslash (PS3.5 6.2).
bool isAeTitle(std::string_view title);

/// Returns "host:port".
std::string hostAndPort(const ArchiveNode& node);

/// Checks the settings of a node; fails and names the node if they are insufficient for a connection attempt.
core::Status checkNode(const ArchiveNode& node);

/// Returns warnings about an unencrypted connection; empty if the connection is encrypted or stays on this computer.
core::Messages connectionWarnings(const ArchiveNode& node);

}   // namespace angiopose::io
