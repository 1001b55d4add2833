#pragma once

#include "core/support/result.h"

#include <string>
#include <string_view>

namespace angiopose::io {

/// What stands in place of names, UIDs and dates: the same for the same original, so that the files of an export fit
/// together, and without the key nobody finds the way back (keyed hashes, HMAC-SHA-256).
class Pseudonyms {
public:
    /// With a random key: exports of different days do not fit together. Fails where the system gives no random bytes.
    static core::Result<Pseudonyms> create();
    /// Exports with the same key fit together; whoever has it can test guesses.
    explicit Pseudonyms(std::string key) : key_(std::move(key)) {}

    /// "2.25." and a number. UIDs that DICOM itself defines stay.
    std::string uid(std::string_view original) const;

    /// "P-" and ten digits, for a patient's ID; where there is none, for the name.
    std::string patient(std::string_view original) const;

    /// yyyymmdd, one to ten years earlier, as many days for all dates of one patient, weeks kept. "" for what is no
    /// date.
    std::string date(std::string_view original, std::string_view patient) const;

private:
    std::string digest(std::string_view role, std::string_view original) const;

    std::string key_;
};

}   // namespace angiopose::io
