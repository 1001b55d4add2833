#include "io/deidentify/identity_words.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace angiopose::io {
namespace {

constexpr std::size_t minLetters = 3;
constexpr int maxDepth = 8;

constexpr std::array<DicomTag, 34> informativeTags{
    0x00080050, 0x00080080, 0x00080081, 0x00080090, 0x00080092, 0x0008009c, 0x00081010, 0x00081040, 0x00081048,
    0x00081050, 0x00081060, 0x00081070, 0x00100010, 0x00100020, 0x00100021, 0x00100030, 0x00101000, 0x00101001,
    0x00101005, 0x00101040, 0x00101060, 0x00102154, 0x00102180, 0x00104000, 0x00180010, 0x00181000, 0x00200010,
    0x00321032, 0x00321033, 0x00380010, 0x00400006, 0x00400241, 0x00401001, 0x0040a123};

bool isLetter(char c)
{
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || static_cast<unsigned char>(c) >= 0x80;
}

template <class Visit>
void eachWord(std::string_view text, const Visit& visit)
{
    std::string word;
    for (const char c : text) {
        if (isLetter(c)) {
            word += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
            continue;
        }
        visit(word);
        word.clear();
    }
    visit(word);
}

}   // namespace

IdentityWords::IdentityWords(const DicomDataset& data)
{
    collect(data, 0);
}

void IdentityWords::collect(const DicomDataset& data, int depth)
{
    const auto take = [&](DicomTag tag) {
        eachWord(data.text(tag), [&](const std::string& word) {
            if (word.size() >= minLetters) {
                words_.insert(word);
            }
        });
    };
    std::ranges::for_each(informativeTags, take);
    if (depth < maxDepth) {
        for (const DicomDataset& item : data.itemsOfAllSequences()) {
            collect(item, depth + 1);
        }
    }
}

bool IdentityWords::occurIn(std::string_view text) const
{
    bool found = false;
    eachWord(text, [&](const std::string& word) { found = found || words_.contains(word); });
    return found;
}

}   // namespace angiopose::io
