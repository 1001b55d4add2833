#include "io/movie/movie_writer.h"
#include "io/movie/yuv_image.h"
#include "tests/io/movie/movie_pictures.h"
#include "tests/support/for_each.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>
#include <unistd.h>
#include <wels/codec_api.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>

namespace angiopose::io {
namespace {

namespace fs = std::filesystem;

std::uint32_t numberAt(const std::string& bytes, std::size_t at, int length = 4)
{
    std::uint32_t value = 0;
    for (int i = 0; i < length; ++i) {
        value = (value << 8) | static_cast<unsigned char>(bytes.at(at + static_cast<std::size_t>(i)));
    }
    return value;
}

/// Content of the first box of that path ("moov/trak/…"), which must fill its parent exactly.
std::optional<std::string> boxContent(const std::string& bytes, const std::string& path)
{
    const std::string type = path.substr(0, path.find('/'));
    for (std::size_t at = 0; at < bytes.size();) {
        const std::size_t size = numberAt(bytes, at);
        if (size < 8 || at + size > bytes.size()) {
            return std::nullopt;
        }
        if (bytes.substr(at + 4, 4) == type) {
            const std::string inside = bytes.substr(at + 8, size - 8);
            return type == path ? std::optional(inside) : boxContent(inside, path.substr(path.find('/') + 1));
        }
        at += size;
    }
    return std::nullopt;
}

/// A movie parsed by its own tables.
struct TakenApart {
    std::string sequence, picture;   ///< parameter sets of avcC
    std::vector<std::string> samples;
    std::vector<std::uint32_t> ticks;
    std::vector<std::uint32_t> whole;
    int width = 0, height = 0;
    std::uint32_t ticksPerSecond = 0;
};

TakenApart takeApart(const std::string& bytes)
{
    TakenApart movie;
    const std::string table = "moov/trak/mdia/minf/stbl/";
    const std::string entry = boxContent(bytes, table + "stsd").value().substr(8 + 8);
    movie.width = static_cast<int>(numberAt(entry, 24, 2));
    movie.height = static_cast<int>(numberAt(entry, 26, 2));
    const std::string configuration = boxContent(entry.substr(78), "avcC").value();
    const std::size_t length = numberAt(configuration, 6, 2);
    movie.sequence = configuration.substr(8, length);
    movie.picture = configuration.substr(11 + length, numberAt(configuration, 9 + length, 2));
    const std::string sizes = boxContent(bytes, table + "stsz").value();
    std::size_t at = numberAt(boxContent(bytes, table + "stco").value(), 8);
    for (std::uint32_t i = 0; i < numberAt(sizes, 8); ++i) {
        const std::size_t size = numberAt(sizes, 12 + 4 * i);
        movie.samples.push_back(bytes.substr(at, size));
        at += size;
    }
    EXPECT_EQ(at, bytes.size()) << "the samples fill the file to its end";
    const std::string times = boxContent(bytes, table + "stts").value();
    for (std::uint32_t row = 0; row < numberAt(times, 4); ++row) {
        movie.ticks.insert(movie.ticks.end(), numberAt(times, 8 + 8 * row), numberAt(times, 12 + 8 * row));
    }
    const std::string starts = boxContent(bytes, table + "stss").value();
    for (std::uint32_t row = 0; row < numberAt(starts, 4); ++row) {
        movie.whole.push_back(numberAt(starts, 8 + 4 * row));
    }
    movie.ticksPerSecond = numberAt(boxContent(bytes, "moov/trak/mdia/mdhd").value(), 12);
    return movie;
}

/// Decodes the file's content with openh264's own decoder; the green of each frame by BT.709.
class Decoder {
public:
    Decoder()
    {
        WelsCreateDecoder(&decoder_);
        SDecodingParam parameters{};
        parameters.sVideoProperty.eVideoBsType = VIDEO_BITSTREAM_AVC;
        decoder_->Initialize(&parameters);
    }
    ~Decoder()
    {
        decoder_->Uninitialize();
        WelsDestroyDecoder(decoder_);
    }
    Decoder(const Decoder&) = delete;
    Decoder& operator=(const Decoder&) = delete;

    std::vector<core::ColorImage> decodeAll(const TakenApart& movie)
    {
        const std::string start("\0\0\0\1", 4);
        std::string stream = start + movie.sequence + start + movie.picture;
        std::vector<core::ColorImage> pictures;
        for (const std::string& sample : movie.samples) {
            for (std::size_t at = 0; at < sample.size();) {
                const std::size_t size = numberAt(sample, at);
                stream += start + sample.substr(at + 4, size);
                at += 4 + size;
            }
            unsigned char* planes[3]{};
            SBufferInfo info{};
            EXPECT_EQ(decoder_->DecodeFrameNoDelay(reinterpret_cast<const unsigned char*>(stream.data()),
                                                   static_cast<int>(stream.size()), planes, &info),
                      dsErrorFree);
            take(planes, info, pictures);
            stream.clear();
        }
        while (pictures.size() <
               movie.samples.size()) {   // the decoder holds frames back for a reordering that we do not write
            unsigned char* planes[3]{};
            SBufferInfo info{};
            decoder_->FlushFrame(planes, &info);
            if (info.iBufferStatus != 1) {
                break;
            }
            take(planes, info, pictures);
        }
        return pictures;
    }

private:
    static void take(unsigned char* const planes[3], const SBufferInfo& info, std::vector<core::ColorImage>& pictures)
    {
        if (info.iBufferStatus == 1) {
            pictures.push_back(colored(planes, info.UsrData.sSystemBuffer));
        }
    }
    static core::ColorImage colored(unsigned char* const planes[3], const SSysMEMBuffer& buffer)
    {
        core::ColorImage picture{buffer.iWidth, buffer.iHeight, {}};
        test::forEachPixel(buffer.iWidth, buffer.iHeight, [&](int x, int y) {
            const double light = 255.0 / 219.0 * (planes[0][y * buffer.iStride[0] + x] - 16);
            const int half = y / 2 * buffer.iStride[1] + x / 2;
            const double blue = 255.0 / 224.0 * (planes[1][half] - 128), red = 255.0 / 224.0 * (planes[2][half] - 128);
            for (const double value :
                 {light + 1.5748 * red, light - 0.1873 * blue - 0.4681 * red, light + 1.8556 * blue}) {
                picture.rgb.push_back(static_cast<std::uint8_t>(std::clamp(std::lround(value), 0L, 255L)));
            }
        });
        return picture;
    }

    ISVCDecoder* decoder_ = nullptr;
};

double meanError(const core::ColorImage& a, const core::ColorImage& b)
{
    double sum = 0.0;
    test::forEachPixel(3 * a.width, a.height, [&](int x, int y) {
        sum += std::abs(a.rgb[static_cast<std::size_t>(3 * y * a.width + x)] -
                        b.rgb[static_cast<std::size_t>(3 * y * b.width + x)]);
    });
    return sum / (3.0 * a.width * a.height);
}

class Mp4Movie : public testing::Test {
protected:
    Mp4Movie() { fs::create_directories(folder_); }
    ~Mp4Movie() override { fs::remove_all(folder_); }

    TakenApart written(int width, int height, int count, double ms)
    {
        auto movie = MovieWriter::create(path_, {width, height}, {"Title", {{"Program", "test"}}});
        EXPECT_TRUE(movie);
        for (int i = 0; i < count; ++i) {
            EXPECT_TRUE(movie.value()->add(moviePicture(width, height, i), ms));
        }
        EXPECT_TRUE(movie.value()->finish());
        return takeApart(test::readText(path_));
    }

    fs::path folder_ = fs::temp_directory_path() / ("mp4-" + std::to_string(::getpid()));
    std::string path_ = (folder_ / "movie.mp4").string();
};

TEST_F(Mp4Movie, PlaysWhatWasGiven)
{
    const TakenApart movie = written(192, 128, 40, 1000.0 / 7.5);
    ASSERT_EQ(movie.samples.size(), 40U);
    Decoder decoder;
    const std::vector<core::ColorImage> shown = decoder.decodeAll(movie);
    ASSERT_EQ(shown.size(), 40U);
    for (int i = 0; i < 40; ++i) {
        const core::ColorImage& picture = shown[static_cast<std::size_t>(i)];
        ASSERT_EQ(picture.width, 192);
        const double own = meanError(moviePicture(192, 128, i), picture);
        EXPECT_LT(own, 3.0) << i;   // colors have half the resolution
        EXPECT_LT(own, 0.5 * meanError(moviePicture(192, 128, i + 8), picture)) << i;
    }
    EXPECT_EQ(movie.whole, (std::vector<std::uint32_t>{1, 31}));
}

/// 24,000 / 1001 fps is not a whole number of ticks: 3753.75.
TEST_F(Mp4Movie, TimesDoNotDrift)
{
    const TakenApart movie = written(32, 32, 40, 1001.0 / 24.0);
    std::uint64_t sum = 0;
    for (std::size_t i = 0; i < movie.ticks.size(); ++i) {
        EXPECT_NEAR(static_cast<double>(sum), 90.0 * static_cast<double>(i) * 1001.0 / 24.0, 0.5);
        sum += movie.ticks[i];
    }
    EXPECT_EQ(movie.ticksPerSecond, 90000U);
}

TEST_F(Mp4Movie, GivesOddSizesAnotherColumnAndRow)
{
    const TakenApart movie = written(101, 67, 2, 40.0);
    EXPECT_EQ(movie.width, 102);
    EXPECT_EQ(movie.height, 68);
    Decoder decoder;
    EXPECT_LT(meanError(moviePicture(101, 67, 0), decoder.decodeAll(movie).at(0)), 4.0);
}

TEST_F(Mp4Movie, HoldsOnePictureAlone)
{
    const TakenApart movie = written(48, 96, 1, 500.0);
    EXPECT_EQ(movie.ticks, std::vector<std::uint32_t>{45000});
    Decoder decoder;
    EXPECT_LT(meanError(moviePicture(48, 96, 0), decoder.decodeAll(movie).at(0)), 4.0);
}

TEST_F(Mp4Movie, TellsTitleColorsAndSize)
{
    written(64, 64, 1, 40.0);
    const std::string bytes = test::readText(path_);
    EXPECT_EQ(bytes.substr(4, 8), "ftypisom");
    EXPECT_LT(bytes.find("moov"), bytes.find("mdat")) << "plays while it is read";
    EXPECT_NE(bytes.find(std::string("colrnclx\0\1\0\1\0\1\0", 15)), std::string::npos);
    EXPECT_NE(bytes.find("Title"), std::string::npos);
    EXPECT_NE(bytes.find("Program: test"), std::string::npos);
    const std::string header = boxContent(bytes, "moov/trak/tkhd").value();
    EXPECT_EQ(numberAt(header, 76), 64U << 16);
}

TEST_F(Mp4Movie, EncodesTheSameTwice)
{
    written(96, 96, 5, 40.0);
    const std::string first = test::readText(path_);
    written(96, 96, 5, 40.0);
    EXPECT_EQ(test::readText(path_), first);
}

TEST_F(Mp4Movie, LeavesNothingWithoutAnEnd)
{
    {
        auto movie = MovieWriter::create(path_, {64, 64}, {});
        ASSERT_TRUE(movie);
        EXPECT_TRUE(movie.value()->add(moviePicture(64, 64, 0), 40.0));
    }
    EXPECT_TRUE(fs::is_empty(folder_));
}

TEST_F(Mp4Movie, KnowsHowLargeItMayBe)
{
    for (const MovieSize& largest : {MovieSize{4096, 2304}, MovieSize{2304, 4096}, MovieSize{8688, 1072}}) {
        EXPECT_FALSE(findProblem(MovieKind::Mp4, largest)) << largest.width;
        EXPECT_TRUE(H264Encoder::create(largest)) << largest.width;   // the library agrees
    }
    EXPECT_TRUE(findProblem(MovieKind::Mp4, {4096, 2320}));
    EXPECT_FALSE(H264Encoder::create({4096, 2320}));
    EXPECT_TRUE(findProblem(MovieKind::Mp4, {8, 512}));
    const auto refused = MovieWriter::create(path_, {4096, 4096}, {});
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().message.text().find("Choose a smaller size, or GIF."), std::string::npos);
    EXPECT_FALSE(MovieWriter::create((folder_ / "movie.avi").string(), {64, 64}, {}));
}

TEST_F(Mp4Movie, RefusesPicturesOfOtherSize)
{
    auto movie = MovieWriter::create(path_, {64, 64}, {});
    ASSERT_TRUE(movie);
    EXPECT_FALSE(movie.value()->add(moviePicture(64, 62, 0), 40.0));
}

}   // namespace
}   // namespace angiopose::io
