#pragma once

#include "core/support/result.h"
#include "io/decode/decoder_reply.h"
#include "io/support/read_observer.h"

#include <string>
#include <vector>

namespace angiopose::io {

/// Runs the helper program `program` with `arguments`, in which a library decodes the file `path`, and returns its
/// reply. `observe` receives the progress and can cancel. If the program crashes, is missing, or exceeds the memory or
/// time appropriate for the file size, fails and names the file. Damage that the library reports is a reply, not a
/// failure.
core::Result<DecoderReply> runDecoder(const std::string& program, const std::vector<std::string>& arguments,
                                      const std::string& path, const ReadObserver& observe = {});

/// Returns the path of a helper program: relative to the running program or the library that contains this code,
/// otherwise in the install location. The file may not exist.
std::string helperPath(const std::string& name);

}   // namespace angiopose::io
