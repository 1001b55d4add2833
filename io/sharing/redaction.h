#pragma once

#include <set>
#include <string>
#include <string_view>

namespace angiopose::io {

/// Takes out of texts what could tell whose they are or who sat before the machine: known identifiers, the user's and
/// the machine's name, folders, names of files, UIDs and dates. Words in brackets stand in their place.
class Redaction {
public:
    /// Knows this machine: home folder, account, host.
    Redaction();

    /// A name or number: it goes, and so does each of its words.
    void addName(std::string_view name);
    /// A description: it goes as a whole, and so do its words but those of the trade ("angiogram", "left").
    void addText(std::string_view text);
    /// Every part of a path.
    void addPath(std::string_view path);

    std::string cleaned(std::string_view text) const;

private:
    void add(std::string_view identifier);

    struct LongestFirst {
        bool operator()(const std::string& a, const std::string& b) const
        {
            return a.size() != b.size() ? a.size() > b.size() : a < b;
        }
    };
    std::set<std::string, LongestFirst> identifiers_;   ///< in small letters
    std::string home_;
};

}   // namespace angiopose::io
