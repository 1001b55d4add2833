#pragma once

#include <string>
#include <vector>

namespace angiopose::core {

/// The word that a misspelt one most likely stands for: at most a third of its letters inserted, left out, changed or
/// swapped (optimal string alignment distance). Empty where none is that near.
std::string nearestWord(const std::string& word, const std::vector<std::string>& words);

}   // namespace angiopose::core