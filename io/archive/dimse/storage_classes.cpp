#include "io/archive/dimse/storage_classes.h"

#include <algorithm>
#include <array>
#include <set>
#include <string>

namespace angiopose::io {
namespace {

constexpr std::array syntaxes = {
    "1.2.840.10008.1.2.1",   // explicit little endian
    "1.2.840.10008.1.2",   // implicit little endian
    "1.2.840.10008.1.2.4.70",   // JPEG lossless, first-order
    "1.2.840.10008.1.2.4.50",   // JPEG baseline
    "1.2.840.10008.1.2.4.90",   // JPEG 2000 lossless
    "1.2.840.10008.1.2.4.91",   // JPEG 2000
    "1.2.840.10008.1.2.5",   // RLE
    "1.2.840.10008.1.2.4.80",   // JPEG-LS lossless
    "1.2.840.10008.1.2.4.81",   // JPEG-LS
    "1.2.840.10008.1.2.4.51",   // JPEG extended
    "1.2.840.10008.1.2.4.57",   // JPEG lossless
    "1.2.840.10008.1.2.1.99",   // deflated
    "1.2.840.10008.1.2.4.102",   // MPEG-4 AVC
    "1.2.840.10008.1.2.4.100",   // MPEG-2
    "1.2.840.10008.1.2.2",   // explicit big endian
    "1.2.840.10008.1.2.4.201",   // high-throughput JPEG 2000 lossless
    "1.2.840.10008.1.2.4.203",   // high-throughput JPEG 2000
};

constexpr std::array usualClasses = {
    "1.2.840.10008.5.1.4.1.1.2",   // CT
    "1.2.840.10008.5.1.4.1.1.12.1",   // XA
    "1.2.840.10008.5.1.4.1.1.2.1",   // enhanced CT
    "1.2.840.10008.5.1.4.1.1.12.1.1",   // enhanced XA
    "1.2.840.10008.5.1.4.1.1.12.2",   // radiofluoroscopy
    "1.2.840.10008.5.1.4.1.1.4",   // MR
    "1.2.840.10008.5.1.4.1.1.4.1",   // enhanced MR
    "1.2.840.10008.5.1.4.1.1.13.1.1",   // X-ray 3-D angiography
    "1.2.840.10008.5.1.4.1.1.66.4",   // segmentation
    "1.2.840.10008.5.1.4.1.1.7",   // secondary capture
    "1.2.840.10008.5.1.4.1.1.104.1",   // PDF
};

}   // namespace

std::span<const char* const> supportedTransferSyntaxes()
{
    return syntaxes;
}

std::vector<ProposedContext> storageContexts(const std::vector<ArchiveObject>& objects, std::size_t others)
{
    std::set<std::string> classes;
    for (const ArchiveObject& object : objects) {
        if (isUid(object.sopClass)) {
            classes.insert(object.sopClass);
        }
    }
    if (classes.empty()) {
        classes.insert(usualClasses.begin(), usualClasses.end());
    }
    const std::size_t room = maxContexts - others;
    const std::size_t perClass = std::clamp<std::size_t>(room / classes.size(), 1, syntaxes.size());
    std::vector<ProposedContext> contexts;
    for (const std::string& sopClass : classes) {
        for (std::size_t i = 0; i < perClass && contexts.size() < room; ++i) {
            contexts.push_back({sopClass, {syntaxes.at(i)}, true});
        }
    }
    return contexts;
}

}   // namespace angiopose::io
