#pragma once

#include "io/decode/decoder_reply.h"

#include <functional>
#include <string>

namespace angiopose::decode {

/// Limits the resources of this process to those needed for a file of the given size: address space of about 64 times
/// the size, a few seconds of processor time, no file writing and no core dumps. A decoder misled by a crafted file is
/// killed at these limits.
void limitProcess(std::size_t fileSize);

/// Reports the progress, 0…1, to the waiting program.
void writeProgress(double fraction);

/// Runs `work` and writes its reply. Running out of memory is reported as such, any other exception as a refusal.
int writeReply(const std::function<io::DecoderReply()>& work);

}   // namespace angiopose::decode
