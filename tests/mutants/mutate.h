#pragma once

#include "core/support/random.h"

#include <string>

namespace angiopose::test {

/// A damaged copy of a file: flipped bits, a cut, lengths of 0xFFFFFFFF, huge or negative numbers in its text, NaN,
/// pieces repeated, or deeper nesting. The same random numbers give the same damage.
std::string mutated(const std::string& content, core::CounterRandom& random);

/// The same, of what is inside a gzip archive; now and then a bomb, or damage to the archive itself.
std::string mutatedGzip(const std::string& content, core::CounterRandom& random);

/// The same, of a PNG: half of them get their checksums right again, so that the damage reaches the decoder.
std::string mutatedPng(const std::string& content, core::CounterRandom& random);

std::string gzipped(const std::string& content);

}   // namespace angiopose::test
