#include "io/raster/read_jpeg.h"

#include <jerror.h>
#include <jpeglib.h>
#include <algorithm>
#include <csetjmp>
#include <cstdio>
#include <numeric>

namespace angiopose::io {
namespace {

constexpr std::size_t maxPixels = 100'000'000;
constexpr JDIMENSION minSide = 8;
constexpr int extraneousBytes = JWRN_EXTRANEOUS_DATA;

/// State of libjpeg, which exits by longjmp: functions that it may leave must not own objects with destructors.
struct JpegState {
    jpeg_decompress_struct decoder;
    jpeg_error_mgr errors;
    std::jmp_buf exit;
};

void leave(j_common_ptr decoder)
{
    std::longjmp(static_cast<JpegState*>(decoder->client_data)->exit, 1);
}

void saySilently(j_common_ptr) {}

/// Counts damage. Extra bytes between markers are not damage, because some vendors pad with them.
void countDamage(j_common_ptr decoder, int level)
{
    if (level < 0 && decoder->err->msg_code != extraneousBytes) {
        ++decoder->err->num_warnings;
    }
}

/// Reads the header and starts decoding to grayscale or RGB.
bool start(JpegState* state, std::string_view content, JpegColors colors)
{
    state->decoder.err = jpeg_std_error(&state->errors);
    state->errors.error_exit = leave;
    state->errors.output_message = saySilently;
    state->errors.emit_message = countDamage;
    jpeg_create_decompress(&state->decoder);
    state->decoder.client_data = state;
    if (setjmp(state->exit) != 0) {
        return false;
    }
    jpeg_mem_src(&state->decoder, reinterpret_cast<const unsigned char*>(content.data()),
                 static_cast<unsigned long>(content.size()));
    jpeg_read_header(&state->decoder, TRUE);
    const auto& head = state->decoder;
    if ((head.num_components != 1 && head.num_components != 3) || head.image_width < minSide ||
        head.image_height < minSide || std::size_t{head.image_width} * head.image_height > maxPixels) {
        return false;
    }
    if (colors == JpegColors::RgbUnlessMarked && head.num_components == 3 && !head.saw_Adobe_marker &&
        !head.saw_JFIF_marker) {
        state->decoder.jpeg_color_space = JCS_RGB;
    }
    state->decoder.out_color_space = head.num_components == 1 ? JCS_GRAYSCALE : JCS_RGB;
    jpeg_start_decompress(&state->decoder);
    return true;
}

bool readRow(JpegState* state, unsigned char* row)
{
    if (setjmp(state->exit) != 0) {
        return false;
    }
    return jpeg_read_scanlines(&state->decoder, &row, 1) == 1;
}

void copyRow(const std::vector<unsigned char>& row, std::size_t y, Raster& raster)
{
    core::ImageF& frame = raster.frames.front();
    const auto width = static_cast<std::size_t>(frame.width);
    const bool isGray = row.size() == width;
    for (std::size_t x = 0; x < width; ++x) {
        frame.pixels[y * width + x] = isGray ? row[x] : raster.luminance(row[3 * x], row[3 * x + 1], row[3 * x + 2]);
    }
}

/// Fills rows that could not be decoded with the mean of the decoded rows, so that they resemble neither vessels nor
/// shutter edges.
void fillFrom(std::size_t firstMissingRow, core::ImageF& frame)
{
    const auto missing =
        frame.pixels.begin() + static_cast<std::ptrdiff_t>(firstMissingRow * static_cast<std::size_t>(frame.width));
    const double sum = std::accumulate(frame.pixels.begin(), missing, 0.0);
    std::fill(missing, frame.pixels.end(),
              static_cast<float>(sum / static_cast<double>(missing - frame.pixels.begin())));
}

}   // namespace

std::optional<Raster> readJpeg(std::string_view content, JpegColors colors)
{
    JpegState state{};
    std::optional<Raster> result;
    if (start(&state, content, colors)) {
        const auto& head = state.decoder;
        Raster raster;
        raster.frames.emplace_back(static_cast<int>(head.output_width), static_cast<int>(head.output_height));
        std::vector<unsigned char> row(std::size_t{head.output_width} *
                                       static_cast<unsigned int>(head.output_components));
        std::size_t y = 0;
        while (y < head.output_height && readRow(&state, row.data())) {
            copyRow(row, y++, raster);
        }
        const bool isWhole = y == head.output_height;
        raster.isPartlyDamaged = !isWhole || state.errors.num_warnings > 0;
        if (2 * y >= head.output_height) {
            fillFrom(y, raster.frames.front());
            result = std::move(raster);
        }
    }
    jpeg_destroy_decompress(&state.decoder);
    return result;
}

}   // namespace angiopose::io
