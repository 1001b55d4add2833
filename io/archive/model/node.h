#pragma once

#include "core/support/result.h"

#include <string>
#include <string_view>
#include <vector>

namespace angiopose::io {

/// An archive that this program may ask: a DICOM node, a DICOMweb address, or both. Of keys and passwords only the
/// paths of their files are known here.
struct ArchiveNode {
    std::string name;   ///< by which the user calls it
    std::string host;   ///< empty: DICOMweb only
    int port = 104;
    std::string title = "ANY-SCP";   ///< its AE title
    std::string ownTitle = "ANGIOPOSE";   ///< ours
    int receivePort = 0;   ///< where it sends what C-MOVE asks for; 0: C-MOVE is not used
    bool isTls = false;
    std::string caFile;   ///< PEM; empty: the authorities that the system trusts
    std::string certificateFile;   ///< ours, PEM; empty: none
    std::string keyFile;
    bool checksHost = true;   ///< whether its certificate must be one of `host`
    std::string webUrl;   ///< "https://pacs/dicom-web"
    std::string authorizationFile;   ///< its first line is sent as the header Authorization
    int answerSeconds = 9;   ///< how long one answer may take
};

/// 1 to 16 letters, digits or signs other than the backslash (PS3.5 6.2).
bool isAeTitle(std::string_view title);

/// "host:port".
std::string addressOf(const ArchiveNode& node);

/// Fails, naming the node, on what no connection can be tried with.
core::Status checkNode(const ArchiveNode& node);

/// What must be known about a connection that is not encrypted; nothing where it is, or stays on this computer.
core::Messages connectionNotes(const ArchiveNode& node);

}   // namespace angiopose::io
