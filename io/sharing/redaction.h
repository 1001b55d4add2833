#pragma once

#include <set>
#include <string>
#include <string_view>

namespace angiopose::io {

/// Removes everything from text that could identify the patient or the user: known identifiers, the names of the user
/// and the computer, folders, file names, UIDs and dates. Replaces these by bracketed placeholders.
class Redaction {
public:
    /// Adds the identifiers of this computer: home folder, account, host name.
    Redaction();

    /// Adds a name or number, which is removed as a whole and word by word.
    void addName(std::string_view name);
    /// Adds a description, which is removed as a whole and word by word, except technical words ("angiogram", "left").
    void addText(std::string_view text);
    /// Adds every component of a path.
    void addPath(std::string_view path);

    std::string redact(std::string_view text) const;

private:
    void add(std::string_view identifier);

    struct LongestFirst {
        bool operator()(const std::string& a, const std::string& b) const
        {
            return a.size() != b.size() ? a.size() > b.size() : a < b;
        }
    };
    std::set<std::string, LongestFirst> identifiers_;   ///< lower-case identifiers, longest first
    std::string home_;
};

}   // namespace angiopose::io
