#include "core/tracing/angiogram/evidence/vessel_network.h"

#include "core/tracing/angiogram/evidence/network_input.h"

#include <algorithm>
#include <mutex>
#include <opencv2/dnn.hpp>
#include <vector>

namespace angiopose::core {
namespace {

constexpr int classCount = 3;   // background, vessel, device
constexpr int triedSidePx = 64;

cv::Mat classesFrom(cv::dnn::Net& net, const NetworkInput& input)
{
    const int sizes[] = {1, NetworkInput::channelCount, input.paddedHeight, input.paddedWidth};
    // OpenCV takes no const; the network only reads it.
    const cv::Mat blob(4, sizes, CV_32F, const_cast<float*>(input.values.data()));
    net.setInput(blob);
    return net.forward();
}

ImageF planeOf(const cv::Mat& classes, int plane, const NetworkInput& input)
{
    ImageF image(input.width, input.height);
    for (int y = 0; y < input.height; ++y) {
        const float* row = classes.ptr<float>(0, plane, y);
        std::copy(row, row + input.width, &image.at(0, y));
    }
    return image;
}

std::optional<cv::dnn::Net> netOf(const std::vector<std::uint8_t>& onnx)
{
    try {
        cv::dnn::Net net = cv::dnn::readNetFromONNX(reinterpret_cast<const char*>(onnx.data()), onnx.size());
        net.setPreferableBackend(cv::dnn::DNN_BACKEND_OPENCV);
        net.setPreferableTarget(cv::dnn::DNN_TARGET_CPU);
        return net;
    } catch (const cv::Exception&) {
        return std::nullopt;
    }
}

bool givesClasses(cv::dnn::Net& net)
{
    const NetworkInput grey = networkInput(ImageF(triedSidePx, triedSidePx));
    try {
        const cv::Mat classes = classesFrom(net, grey);
        return classes.dims == 4 && classes.size[1] == classCount && classes.size[2] == grey.paddedHeight &&
               classes.size[3] == grey.paddedWidth && classes.type() == CV_32F;
    } catch (const cv::Exception&) {
        return false;
    }
}

}   // namespace

/// OpenCV's networks serve one thread at a time.
struct VesselNetwork::Copies {
    std::vector<std::uint8_t> onnx;
    std::mutex mutex;
    std::vector<cv::dnn::Net> idle;

    cv::dnn::Net take()
    {
        {
            const std::lock_guard lock(mutex);
            if (!idle.empty()) {
                cv::dnn::Net net = std::move(idle.back());
                idle.pop_back();
                return net;
            }
        }
        return *netOf(onnx);
    }

    void giveBack(cv::dnn::Net net)
    {
        const std::lock_guard lock(mutex);
        idle.push_back(std::move(net));
    }
};

std::optional<VesselNetwork> VesselNetwork::read(std::span<const std::uint8_t> onnx)
{
    auto copies = std::make_shared<Copies>();
    copies->onnx.assign(onnx.begin(), onnx.end());
    auto net = netOf(copies->onnx);
    if (!net || !givesClasses(*net)) {
        return std::nullopt;
    }
    copies->giveBack(std::move(*net));
    return VesselNetwork(std::move(copies));
}

FrameClasses VesselNetwork::classesOf(const ImageF& vesselsDark) const
{
    const NetworkInput input = networkInput(vesselsDark);
    cv::dnn::Net net = copies_->take();
    const cv::Mat classes = classesFrom(net, input);
    FrameClasses seen{resampled(planeOf(classes, 1, input), vesselsDark.width, vesselsDark.height),
                      resampled(planeOf(classes, 2, input), vesselsDark.width, vesselsDark.height)};
    copies_->giveBack(std::move(net));
    return seen;
}

}   // namespace angiopose::core
