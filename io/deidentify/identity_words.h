#pragma once

#include "io/dicom/dicom_dataset.h"

#include <set>
#include <string>
#include <string_view>

namespace angiopose::io {

/// Words in a data set that identify the patient: names, numbers and addresses of the patient, the request, the staff
/// and the institution. Used to check codes that would otherwise be kept.
class IdentityWords {
public:
    explicit IdentityWords(const DicomDataset& data);

    /// Returns whether `text` contains one of the words, ignoring case.
    bool occurIn(std::string_view text) const;

private:
    void collect(const DicomDataset& data, int depth);

    std::set<std::string> words_;   ///< upper-case words
};

}   // namespace angiopose::io
