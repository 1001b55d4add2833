#pragma once

#include <string>
#include <vector>

namespace angiopose::core {

/// Returns the most likely correction of a misspelled word: the nearest word with at most a third of its letters
/// inserted, omitted, changed or swapped (optimal string alignment distance); empty if no word is that close.
std::string nearestWord(const std::string& word, const std::vector<std::string>& words);

}   // namespace angiopose::core
