#include "io/dicom/decode_jpeg2000.h"

#include <openjpeg-2.5/openjpeg.h>   // versioned path, because ITK contains an older, renamed copy
#include <algorithm>
#include <cstring>
#include <memory>

namespace angiopose::io {
namespace {

/// In-memory input of OpenJPEG.
struct Jpeg2000Source {
    std::string_view bytes;
    std::size_t at = 0;
};

OPJ_SIZE_T readSource(void* buffer, OPJ_SIZE_T size, void* user)
{
    auto& source = *static_cast<Jpeg2000Source*>(user);
    const std::size_t count = std::min<std::size_t>(size, source.bytes.size() - source.at);
    std::memcpy(buffer, source.bytes.data() + source.at, count);
    source.at += count;
    return count == 0 ? static_cast<OPJ_SIZE_T>(-1) : count;
}

OPJ_BOOL seekSource(OPJ_OFF_T place, void* user)
{
    auto& source = *static_cast<Jpeg2000Source*>(user);
    source.at = std::min(source.bytes.size(), static_cast<std::size_t>(std::max<OPJ_OFF_T>(place, 0)));
    return OPJ_TRUE;
}

OPJ_OFF_T skipSource(OPJ_OFF_T count, void* user)
{
    seekSource(static_cast<OPJ_OFF_T>(static_cast<Jpeg2000Source*>(user)->at) + count, user);
    return count;
}

using Jpeg2000Image = std::unique_ptr<opj_image_t, decltype(&opj_image_destroy)>;

Jpeg2000Image decodedImage(std::string_view compressed)
{
    Jpeg2000Source source{compressed};
    const std::unique_ptr<opj_stream_t, decltype(&opj_stream_destroy)> stream(opj_stream_default_create(OPJ_TRUE),
                                                                              opj_stream_destroy);
    opj_stream_set_user_data(stream.get(), &source, nullptr);
    opj_stream_set_user_data_length(stream.get(), compressed.size());
    opj_stream_set_read_function(stream.get(), readSource);
    opj_stream_set_skip_function(stream.get(), skipSource);
    opj_stream_set_seek_function(stream.get(), seekSource);
    const bool isCodestream = compressed.starts_with("\xff\x4f");
    const std::unique_ptr<opj_codec_t, decltype(&opj_destroy_codec)> codec(
        opj_create_decompress(isCodestream ? OPJ_CODEC_J2K : OPJ_CODEC_JP2), opj_destroy_codec);
    opj_dparameters_t parameters;
    opj_set_default_decoder_parameters(&parameters);
    opj_image_t* image = nullptr;
    const bool isRead = opj_setup_decoder(codec.get(), &parameters) == OPJ_TRUE &&
                        opj_read_header(stream.get(), codec.get(), &image) == OPJ_TRUE;
    const bool isDecoded = isRead && opj_decode(codec.get(), stream.get(), image) == OPJ_TRUE;
    Jpeg2000Image result(image, opj_image_destroy);
    if (!isDecoded) {
        result.reset();
    }
    return result;
}

}   // namespace

std::optional<std::vector<char>> decodeJpeg2000(std::string_view compressed, const PixelLayout& layout)
{
    const Jpeg2000Image image = decodedImage(compressed);
    const auto samples = static_cast<std::size_t>(layout.samples);
    if (!image || image->numcomps != samples) {
        return std::nullopt;
    }
    const auto bytesPerSample = static_cast<std::size_t>(layout.bitsAllocated / 8);
    std::vector<char> bytes(layout.pixelsPerFrame() * samples * bytesPerSample);
    for (std::size_t c = 0; c < samples; ++c) {
        const opj_image_comp_t& plane = image->comps[c];
        if (!plane.data || std::size_t{plane.w} * plane.h != layout.pixelsPerFrame()) {
            return std::nullopt;
        }
        for (std::size_t i = 0; i < layout.pixelsPerFrame(); ++i) {
            std::memcpy(bytes.data() + (i * samples + c) * bytesPerSample, plane.data + i, bytesPerSample);
        }
    }
    return bytes;
}

}   // namespace angiopose::io
