#include "io/dicom/dicom_file.h"
#include "io/messages/messages.h"

#include <gtest/gtest.h>

using namespace angiopose;

namespace {

std::string number(std::size_t value, int bytes)
{
    std::string text;
    for (int i = 0; i < bytes; ++i) {
        text += static_cast<char>(value >> (8 * i) & 0xff);
    }
    return text;
}

std::string tagBytes(io::DicomTag tag)
{
    return number(tag >> 16, 2) + number(tag, 2);
}

std::string shortElement(io::DicomTag tag, const std::string& vr, const std::string& value)
{
    return tagBytes(tag) + vr + number(value.size(), 2) + value;
}

std::string longElement(io::DicomTag tag, const std::string& vr, const std::string& value)
{
    return tagBytes(tag) + vr + std::string(2, '\0') + number(value.size(), 4) + value;
}

std::string gateItem(const std::string& elements)
{
    return tagBytes(0xfffee000) + number(elements.size(), 4) + elements;
}

io::DicomFile parsed(const std::string& bytes)
{
    const std::string name = shortElement(0x00080060, "CS", "XA");
    auto file = io::parseDicom("DICM" + name + bytes, "made.dcm");
    EXPECT_TRUE(file) << file.error().message;
    return file ? std::move(file).value() : io::DicomFile{};
}

const std::string rowsElement = shortElement(0x00280010, "US", number(512, 2));

}   // namespace

TEST(DicomGate, FindsAnElementWhoseVrWasForgotten)
{
    const std::string bare = tagBytes(0x00181110) + number(4, 4) + "1020";
    const io::DicomFile file = parsed(bare + rowsElement);
    EXPECT_EQ(file.dataset.number(0x00181110), 1020.0);
    EXPECT_EQ(file.dataset.integer(0x00280010), 512);
    EXPECT_FALSE(file.damage);
}

TEST(DicomGate, ReadsNumbersWhoseVrIsUnknown)
{
    EXPECT_EQ(parsed(longElement(0x00280010, "UN", number(300, 2))).dataset.integer(0x00280010), 300);
}

TEST(DicomGate, LeavesOutASequenceThatIsDamagedInside)
{
    const std::string damaged = gateItem(tagBytes(0x00081155) + "UI" + number(5000, 2) + "1.2");
    const io::DicomFile file = parsed(longElement(0x00081140, "SQ", damaged) + rowsElement);
    EXPECT_FALSE(file.dataset.has(0x00081140));
    EXPECT_EQ(file.dataset.integer(0x00280010), 512);
    EXPECT_FALSE(file.damage);
}

TEST(DicomGate, KeepsTheItemsOfSoundSequences)
{
    const std::string items =
        gateItem(shortElement(0x00181510, "DS", "30")) + gateItem(shortElement(0x00181510, "DS", "-5"));
    const auto found = parsed(longElement(0x00081140, "SQ", items)).dataset.items(0x00081140);
    ASSERT_EQ(found.size(), 2U);
    EXPECT_EQ(found[0].number(0x00181510), 30.0);
    EXPECT_EQ(found[1].number(0x00181510), -5.0);
}

TEST(DicomGate, LetsThroughOnlyShortNumbersOfTheGantryAmongPrivateElements)
{
    const std::string creator = shortElement(0x00210010, "LO", "SIEMENS SMS-AX  ACQ 1.0 ");
    const io::DicomFile file =
        parsed(shortElement(0x00190010, "LO", "SOMEBODY") + creator + shortElement(0x00211017, "IS", "750 ") +
               longElement(0x00211018, "UN", std::string(66, 'x')) +
               longElement(0x00211019, "SQ", gateItem(shortElement(0x00181510, "DS", "30"))) + rowsElement);
    EXPECT_EQ(file.dataset.number(0x00211017), 750.0);
    for (const io::DicomTag tag : {0x00190010U, 0x00211018U, 0x00211019U}) {
        EXPECT_FALSE(file.dataset.has(tag));
    }
    EXPECT_EQ(file.dataset.integer(0x00280010), 512);
}

TEST(DicomGate, LeavesOutWhatIsNestedTooDeeply)
{
    std::string nested;
    for (int depth = 0; depth < 2'000; ++depth) {
        nested = gateItem(longElement(0x00081140, "SQ", nested));
    }
    const io::DicomFile file = parsed(longElement(0x00081140, "SQ", nested) + rowsElement);
    EXPECT_FALSE(file.dataset.has(0x00081140));
    EXPECT_EQ(file.dataset.integer(0x00280010), 512);
}

TEST(DicomGate, KeepsTheRecordsOfADirectoryFromDcmtk)
{
    const std::string types = std::string(100, 'A') + '\\' + std::string(100, 'B');
    const std::string records = gateItem(shortElement(0x00041430, "CS", types));
    for (const char* vr : {"SQ", "UN"}) {
        const std::string directory = longElement(0x00041220, vr, records);
        EXPECT_FALSE(parsed(directory + rowsElement).dataset.has(0x00041220));
        const io::DicomFile nested = parsed(longElement(0x00081140, "SQ", gateItem(directory)) + rowsElement);
        EXPECT_FALSE(nested.dataset.has(0x00081140));
        EXPECT_EQ(nested.dataset.integer(0x00280010), 512);
    }
}

/// Found by fuzzing: the walk continued past the end of the file.
TEST(DicomGate, ASequenceUntilADelimiterEndsWithTheItemAroundIt)
{
    const std::string open = tagBytes(0x00081115) + "SQ" + std::string(2, '\0') + number(0xffffffff, 4);
    const std::string inner = open + gateItem(shortElement(0x00181510, "DS", "30"));
    const std::string end = tagBytes(0xfffee0dd) + number(0, 4);
    const std::string behind = tagBytes(0x00081199) + "UN" + std::string(2, '\0') + number(60'000, 4);
    const std::string outer = longElement(0x00081140, "SQ", gateItem(inner)) + end + behind;
    const io::DicomFile late = parsed(outer);
    EXPECT_FALSE(late.dataset.has(0x00081140));
    const io::DicomFile sound = parsed(longElement(0x00081140, "SQ", gateItem(inner + end)) + rowsElement);
    ASSERT_EQ(sound.dataset.items(0x00081140).size(), 1U);
    EXPECT_EQ(sound.dataset.items(0x00081140)[0].items(0x00081115).at(0).number(0x00181510), 30.0);
    EXPECT_EQ(sound.dataset.integer(0x00280010), 512);
}

TEST(DicomGate, NamesTheElementThatIsCutShort)
{
    const io::DicomFile file = parsed(rowsElement + longElement(0x7fe00010, "OW", std::string(100, 'p')).substr(0, 60));
    ASSERT_TRUE(file.damage);
    EXPECT_TRUE(file.damage->is(io::messages::dicomElementTooLong));
    EXPECT_EQ(file.pixels.at(io::pixelDataTag).bytes.size(), 48U);
}
