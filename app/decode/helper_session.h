#pragma once

#include "io/decode/decoder_reply.h"

#include <functional>
#include <string>

namespace angiopose::decode {

/// Limits the resources of this process to those needed for a file of the given size: address space of about 64 times
/// the size, a few seconds of processor time, no file writing and no core dumps. The system kills a decoder that a
/// crafted file drives beyond these limits.
void limitProcess(std::size_t fileSize);

/// Reports the progress, 0…1, to the waiting program.
void writeProgress(double fraction);

/// Runs `work` and writes its reply. Reports exhausted memory as such and any other exception as a refusal.
int writeReply(const std::function<io::DecoderReply()>& work);

}   // namespace angiopose::decode
