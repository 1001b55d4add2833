#pragma once

#include "io/decode/decoder_reply.h"

#include <functional>
#include <string>

namespace angiopose::decode {

/// Takes from this process what decoding a file of that size cannot need: address space beyond some 64 times the size,
/// processor time beyond seconds, files to write to, core dumps. A decoder that is led astray ends here.
void limitProcess(std::size_t fileSize);

/// Tells the program that waits how far the work is, 0…1.
void sayProgress(double fraction);

/// Runs `work` and writes what it returns, or that memory ran out; what else it throws is a refusal.
int sayReply(const std::function<io::DecoderReply()>& work);

}   // namespace angiopose::decode
