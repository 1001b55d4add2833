#include "io/dicom/dicom_text.h"

#include <gtest/gtest.h>
#include <string>

using namespace angiopose;

namespace {

void add(std::string& bytes, io::DicomTag tag, const char* vr, std::string value)
{
    value += value.size() % 2 == 0 ? "" : " ";
    for (const std::size_t number : {std::size_t{tag >> 16U}, std::size_t{tag & 0xffffU}}) {
        bytes += static_cast<char>(number & 0xff);
        bytes += static_cast<char>(number >> 8U);
    }
    bytes += vr;
    bytes += static_cast<char>(value.size() & 0xff);
    bytes += static_cast<char>(value.size() >> 8U);
    bytes += value;
}

std::string nameOf(const std::string& characterSets, const std::string& bytes)
{
    std::string elements;
    if (!characterSets.empty()) {
        add(elements, 0x00080005, "CS", characterSets);
    }
    add(elements, 0x00100010, "PN", bytes);
    return io::utf8Text(io::readElements(elements, io::DicomEncoding{}), 0x00100010);
}

}   // namespace

// Names from PS3.5 annexes H and I.
TEST(DicomText, ChangesBetweenSetsByTheirEscapeSequences)
{
    EXPECT_EQ(nameOf("\\ISO 2022 IR 87",
                     "Yamada^Tarou=\x1b$B;3ED\x1b(B^\x1b$BB@O:\x1b(B=\x1b$B$d$^$@\x1b(B^"
                     "\x1b$B$?$m$&\x1b(B"),
              "Yamada^Tarou=山田^太郎=やまだ^たろう");
    EXPECT_EQ(nameOf("ISO 2022 IR 13\\ISO 2022 IR 87",
                     "\xd4\xcf\xc0\xde^\xc0\xdb\xb3=\x1b$B;3ED\x1b(J^\x1b$BB@O:\x1b(J=\x1b$B$d$^$@\x1b(J^"
                     "\x1b$B$?$m$&\x1b(J"),
              "ﾔﾏﾀﾞ^ﾀﾛｳ=山田^太郎=やまだ^たろう");
    EXPECT_EQ(nameOf("\\ISO 2022 IR 149",
                     "Hong^Gildong=\x1b$)C\xfb\xf3^\x1b$)C\xd1\xce\xd4\xd7=\x1b$)C\xc8\xab^"
                     "\x1b$)C\xb1\xe6\xb5\xbf"),
              "Hong^Gildong=洪^吉洞=홍^길동");
    EXPECT_EQ(nameOf("\\ISO 2022 IR 58", "Zhang^XiaoDong=\x1b$)A\xd5\xc5^\x1b$)A\xd0\xa1\xb6\xab="),
              "Zhang^XiaoDong=张^小东=");
    // The first character set applies again after a delimiter.
    EXPECT_EQ(nameOf("ISO 2022 IR 100\\ISO 2022 IR 144", "M\xfcller=\x1b-L\xbb\xee\xda=M\xfcller"),
              "Müller=Люк=Müller");
    EXPECT_EQ(nameOf("\\ISO 2022 IR 87", "\x1b[1mA"), "1mA") << "no escape character comes through";
}

TEST(DicomText, OfOneSet)
{
    EXPECT_EQ(nameOf("ISO_IR 192", "M\xc3\xbcller"), "Müller");
    EXPECT_EQ(nameOf("ISO_IR 101", "Dvo\xf8\xe1k"), "Dvořák");
    EXPECT_EQ(nameOf("GB18030", "Wang=\xcd\xf5^\xd0\xa1\xb6\xab"), "Wang=王^小东");
    EXPECT_EQ(nameOf("\\ISO 2022 IR 149", "\xc8\xab^\xb1\xe6\xb5\xbf"), "홍^길동") << "escape sequences forgotten";
}

TEST(DicomText, WithoutAFittingSetIsUtf8WhereItCanBe)
{
    for (const char* sets : {"", "ISO_IR 6", "ISO_IR 192"}) {
        EXPECT_EQ(nameOf(sets, "M\xc3\xbcller^J\xc3\xb6rg"), "Müller^Jörg") << sets;
        EXPECT_EQ(nameOf(sets, "M\xfcller^J\xf6rg"), "Müller^Jörg") << sets;
    }
}
