#pragma once

#include "io/deidentify/identity_words.h"

#include <string>

namespace angiopose::io {

/// Value, scheme and meaning of a coded term (PS3.3 8.8), as read.
struct ReadTerm {
    std::string value;
    std::string scheme;
    std::string meaning;
};

/// What a term becomes that goes to others.
struct KeptTerm {
    ReadTerm term;
    bool isReplaced = false;   ///< by one that says it was taken out
};

/// Values stay where the scheme is a public one and they look as its values do; of units and of this program's own
/// terms those that are known. Meanings are free words: the known ones stay, in place of others stands the value.
KeptTerm keptTerm(const ReadTerm& term, const IdentityWords& words);

}   // namespace angiopose::io
