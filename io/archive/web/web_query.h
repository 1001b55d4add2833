#pragma once

#include "io/archive/web/http.h"

#include <string>

namespace angiopose::io {

/// The address of a node without a last slash.
std::string webBase(const ArchiveNode& node);

/// The JSON that answers a query; empty where nothing matches. Fails, naming the service, on any other status.
core::Result<std::string> askWeb(HttpConnection& http, const ArchiveNode& node, const std::string& service,
                                 const std::string& url);

}   // namespace angiopose::io
