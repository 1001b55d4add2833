#pragma once

#include "io/decode/decoder_reply.h"

#include <functional>
#include <string>

namespace angiopose::decode {

/// Limits this process to the resources that decoding a file of the given size needs: address space of about 64 times
/// the size, a few seconds of processor time, no file writing and no core dumps. A decoder misled by a crafted file
/// ends here.
void limitProcess(std::size_t fileSize);

/// Reports the progress, 0…1, to the waiting program.
void sayProgress(double fraction);

/// Runs `work` and writes its reply. Running out of memory is reported as such; any other exception becomes a refusal.
int sayReply(const std::function<io::DecoderReply()>& work);

}   // namespace angiopose::decode
