#pragma once

#include <set>
#include <string>
#include <string_view>

namespace core_texts {

/// The sentences that C++ source text can say, as templates: `"Only " + percent(x) + " is seen."` gives
/// "Only %1 is seen.". A literal alone counts when it has at least two words, so keys and units stay out; the branches
/// of a conditional inside a sentence count always.
std::set<std::string> scanSentences(std::string_view source);

}   // namespace core_texts
