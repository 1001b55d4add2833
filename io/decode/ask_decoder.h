#pragma once

#include "core/support/result.h"
#include "io/decode/decoder_reply.h"
#include "io/support/read_observer.h"

#include <string>
#include <vector>

namespace angiopose::io {

/// Runs a helper program (its name, followed by `arguments`) in which a library decodes the file `path`, and returns
/// its reply. `observe` receives the progress and can cancel. Fails, naming the file, if the program crashes, is
/// missing, or exceeds the memory and time appropriate for a file of that size. Damage reported by the library is a
/// reply, not a failure.
core::Result<DecoderReply> askDecoder(const std::string& program, const std::vector<std::string>& arguments,
                                      const std::string& path, const ReadObserver& observe = {});

/// Path of a helper program of AngioPose, relative to the running program or the library that contains this code, or
/// else at the install location. The file may not exist.
std::string helperProgram(const std::string& name);

}   // namespace angiopose::io
