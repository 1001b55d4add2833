#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace core_texts {

/// As much of C++ as sentences need: literals, names, single punctuation marks, and what stands in brackets.
struct Token {
    enum class Kind { Literal, Name, Mark, Group };

    Kind kind;
    std::string text;   ///< the literal's value, the name, the mark, or the opening bracket
    std::vector<Token> inside{};   ///< of a group
};

/// Comments, preprocessor lines and character literals are left out.
std::vector<Token> tokensOf(std::string_view source);

}   // namespace core_texts
