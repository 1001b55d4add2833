#pragma once

#include "core/support/random.h"

#include <string>

namespace angiopose::test {

/// A damaged copy of a file: flipped bits, truncation, lengths of 0xFFFFFFFF, huge or negative numbers in its text,
/// NaN, repeated pieces or deeper nesting. The same random numbers give the same damage.
std::string mutated(const std::string& content, core::CounterRandom& random);

/// Damages the content of a gzip archive; occasionally adds a decompression bomb or damages the archive itself.
std::string mutatedGzip(const std::string& content, core::CounterRandom& random);

/// Damages a PNG; half of the mutants get correct checksums again, so that the damage reaches the decoder.
std::string mutatedPng(const std::string& content, core::CounterRandom& random);

std::string gzipped(const std::string& content);

}   // namespace angiopose::test
