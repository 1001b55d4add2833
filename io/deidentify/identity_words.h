#pragma once

#include "io/dicom/dicom_dataset.h"

#include <set>
#include <string>
#include <string_view>

namespace angiopose::io {

/// Words in a data set that identify the patient: names, numbers and addresses of the patient, the request, staff and
/// the institution. Codes that are normally kept are checked for these words.
class IdentityWords {
public:
    explicit IdentityWords(const DicomDataset& data);

    /// Whether `text` contains one of the words, ignoring case.
    bool areIn(std::string_view text) const;

private:
    void collect(const DicomDataset& data, int depth);

    std::set<std::string> words_;   ///< in upper case
};

}   // namespace angiopose::io
