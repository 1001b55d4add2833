#pragma once

#include "core/support/result.h"
#include "io/decode/decoder_reply.h"
#include "io/support/read_observer.h"

#include <string>
#include <vector>

namespace angiopose::io {

/// Starts a helper program (its name; `arguments` after it) in which a library decodes the file `path`, and waits for
/// what it says. The observer hears of progress and may stop it. Fails, naming the file, when the program dies, runs
/// out of the memory and time that a file of that size may need, or is not there; a library that finds the file
/// damaged is no failure here but a reply.
core::Result<DecoderReply> askDecoder(const std::string& program, const std::vector<std::string>& arguments,
                                      const std::string& path, const ReadObserver& observe = {});

/// Path of a program that AngioPose brings along: below the folder that holds the running program, or the library that
/// this code is part of, or where it was to be installed. It may be missing there.
std::string helperProgram(const std::string& name);

}   // namespace angiopose::io
