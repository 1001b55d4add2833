#pragma once

#include "io/case/fields/stored_field.h"

#include <algorithm>
#include <array>

namespace angiopose::io {

/// Returns the row of an enumeration stored as a word; `words` lists the permitted words in enumerator order.
template <class Owner, class Choice, std::size_t Count>
StoredField<Owner> enumField(std::string key, Json schema, Choice Owner::*member,
                             const std::array<const char*, Count>& words)
{
    return {std::move(key), std::move(schema),
            [member, words](const Json& value, Owner& owner, ReadContext&) {
                const auto found = std::ranges::find(words, value.get<std::string>());
                owner.*member = static_cast<Choice>(found - words.begin());
            },
            [member, words](const Owner& owner, const std::filesystem::path&) {
                return Json(words[static_cast<std::size_t>(owner.*member)]);
            }};
}

}   // namespace angiopose::io
