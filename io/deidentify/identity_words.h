#pragma once

#include "io/dicom/dicom_dataset.h"

#include <set>
#include <string>
#include <string_view>

namespace angiopose::io {

/// The words by which a data set tells whose it is: names, numbers and places of the patient, of the request, of people
/// and of the institution. Codes that may stay as a rule are looked at, whether somebody wrote one of these in them.
class IdentityWords {
public:
    explicit IdentityWords(const DicomDataset& data);

    /// Whether `text` holds one of the words, whatever the case of its letters.
    bool areIn(std::string_view text) const;

private:
    void collect(const DicomDataset& data, int depth);

    std::set<std::string> words_;   ///< capitals
};

}   // namespace angiopose::io
