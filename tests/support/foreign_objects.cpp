#include "tests/support/foreign_objects.h"

#include "core/imaging/gray_statistics.h"
#include "core/imaging/image_filters.h"
#include "core/simulation/splat_disc.h"
#include "core/support/random.h"
#include "tests/support/drawn_letters.h"
#include "tests/support/for_each.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace angiopose::test {
namespace {

using core::CounterRandom;
using core::ImageF;
using Eigen::Vector2d;

/// Difference in gray value between the darkest and the brightest parts of the image.
double contrastOf(const ImageF& frame)
{
    const std::vector<float> ends = core::grayQuantiles(frame.pixels, {0.02, 0.98});
    return ends[1] - ends[0];
}

Vector2d middleOf(const ImageF& frame)
{
    return {0.5 * (frame.width - 1), 0.5 * (frame.height - 1)};
}

double sideOf(const ImageF& frame)
{
    return std::min(frame.width, frame.height);
}

/// Absorption along the chord of a tube, in units of its diameter: 1 at its axis.
ImageF tube(const ImageF& frame, const std::vector<Path>& courses, double radiusPx)
{
    constexpr double stepPx = 0.5;
    ImageF depth(frame.width, frame.height);
    for (const Path& course : courses) {
        for (std::size_t i = 1; i < course.size(); ++i) {
            const Vector2d along = course[i] - course[i - 1];
            const int steps = std::max(1, static_cast<int>(std::lround(along.norm() / stepPx)));
            for (int k = 0; k < steps; ++k) {
                core::splatDisc(depth, course[i - 1] + along * k / steps, radiusPx,
                                along.norm() / steps / (2.0 * radiusPx));
            }
        }
    }
    return depth;
}

ImageF darkened(ImageF frame, const ImageF& depth, double by)
{
    const ImageF seen = core::gaussianBlur(depth, 0.7);
    for (std::size_t i = 0; i < frame.pixels.size(); ++i) {
        frame.pixels[i] -= static_cast<float>(by) * seen.pixels[i];
    }
    return frame;
}

/// A path from one edge of the frame into it or across it, with constant curvature.
Path deviceCourse(const ImageF& frame, CounterRandom& random, double share)
{
    const double side = sideOf(frame);
    const double turn = random.uniform(0.0, 2.0 * std::numbers::pi);
    const Vector2d inwards(std::cos(turn), std::sin(turn));
    const Vector2d across(-inwards.y(), inwards.x());
    const Vector2d start = middleOf(frame) - 0.72 * side * inwards + random.uniform(-0.3, 0.3) * side * across;
    const double deformation = random.uniform(-0.6, 0.6) / side;
    Path course;
    Vector2d at = start;
    double angle = turn + random.uniform(-0.3, 0.3);
    for (double way = 0.0; way < (0.3 + share) * side; way += 2.0) {
        at += 2.0 * Vector2d(std::cos(angle), std::sin(angle));
        angle += 2.0 * deformation;
        course.push_back(at);
    }
    return course;
}

ObjectFrame withCatheter(const ImageF& frame, std::uint64_t seed, bool isHollow)
{
    CounterRandom random(seed);
    const std::vector<Path> courses{deviceCourse(frame, random, random.uniform(0.3, 0.8))};
    const double radiusPx = random.uniform(0.008, 0.014) * sideOf(frame);
    ImageF depth = tube(frame, courses, radiusPx);
    if (isHollow) {
        const ImageF lumen = tube(frame, courses, 0.7 * radiusPx);
        for (std::size_t i = 0; i < depth.pixels.size(); ++i) {
            depth.pixels[i] = 2.0F * (depth.pixels[i] - 0.7F * lumen.pixels[i]);
        }
    }
    return {darkened(frame, depth, random.uniform(0.15, 0.35) * contrastOf(frame)), courses, radiusPx + 2.0};
}

ObjectFrame withWire(const ImageF& frame, std::uint64_t seed)
{
    CounterRandom random(seed);
    const std::vector<Path> courses{deviceCourse(frame, random, random.uniform(0.5, 1.3))};
    const ImageF depth = tube(frame, courses, random.uniform(0.7, 1.2));
    return {darkened(frame, depth, random.uniform(0.2, 0.5) * contrastOf(frame)), courses, 3.0};
}

/// Draws twisted loops of wire, one above the other, as in a closed sternum.
ObjectFrame withSternalWires(const ImageF& frame, std::uint64_t seed)
{
    CounterRandom random(seed);
    const double side = sideOf(frame);
    const double x = random.uniform(0.25, 0.75) * frame.width;
    std::vector<Path> courses;
    for (int k = 0; k < 4; ++k) {
        const Vector2d center(x + random.uniform(-0.03, 0.03) * side, (0.18 + 0.2 * k) * frame.height);
        const double radius = random.uniform(0.03, 0.06) * side;
        const double squash = random.uniform(0.3, 1.0);
        Path loop;
        for (int step = 0; step <= 60; ++step) {
            const double angle = 2.0 * std::numbers::pi * step / 60.0;
            loop.push_back(center + radius * Vector2d(std::cos(angle), squash * std::sin(angle)));
        }
        courses.push_back(loop);
        courses.push_back(line(center + Vector2d(0.0, radius * squash),
                               center + Vector2d(0.02 * side, radius * squash + 0.03 * side)));
    }
    const ImageF depth = tube(frame, courses, 1.0);
    return {darkened(frame, depth, random.uniform(0.3, 0.6) * contrastOf(frame)), courses, 3.0};
}

ObjectFrame withClips(const ImageF& frame, std::uint64_t seed)
{
    CounterRandom random(seed);
    const double side = sideOf(frame);
    std::vector<Path> courses;
    for (int k = 0; k < 8; ++k) {
        const Vector2d at(random.uniform(0.1, 0.9) * frame.width, random.uniform(0.1, 0.9) * frame.height);
        const double turn = random.uniform(0.0, std::numbers::pi);
        const Vector2d half = random.uniform(0.01, 0.025) * side * Vector2d(std::cos(turn), std::sin(turn));
        courses.push_back(line(at - half, at + half));
    }
    return {darkened(frame, tube(frame, courses, 1.5), 0.6 * contrastOf(frame)), courses, 4.0};
}

ObjectFrame withText(const ImageF& frame, std::uint64_t seed)
{
    CounterRandom random(seed);
    const std::vector<float> ends = core::grayQuantiles(frame.pixels, {0.001, 0.999});
    ObjectFrame object{frame, {}, 9.0};
    for (int row = 0; row < 5; ++row) {
        const int count = 4 + random.index(8);
        const int most = frame.width - 14 * count - 2;
        const Eigen::Vector2i at(random.uniform() < 0.7 ? 4 : random.index(most), 6 + row * (frame.height - 24) / 4);
        writeLetters(object.frame, at, count, random.uniform() < 0.7 ? ends[1] : ends[0]);
        object.courses.push_back(line(Vector2d(at.x(), at.y() + 7), Vector2d(at.x() + 14.0 * count - 4.0, at.y() + 7)));
    }
    return object;
}

/// Exposes the pixels given by `inside`; all others get one gray value, dark or (rarely) bright, with a little noise.
template <class Inside>
ImageF bordered(const ImageF& frame, CounterRandom& random, double softPx, const Inside& inside)
{
    const std::vector<float> ends = core::grayQuantiles(frame.pixels, {0.0, 0.05, 1.0});
    const double outside = random.uniform() < 0.5 ? ends[0] : random.uniform() < 0.7 ? ends[1] : ends[2];
    const double noise = random.uniform() < 0.5 ? 0.01 * (ends[2] - ends[0]) : 0.0;
    ImageF result = frame;
    test::forEachPixel(frame.width, frame.height, [&](int x, int y) {
        const double share = 1.0 / (1.0 + std::exp(-std::clamp(inside(Vector2d(x, y)) / softPx, -30.0, 30.0)));
        result.at(x, y) =
            static_cast<float>(share * result.at(x, y) + (1.0 - share) * (outside + noise * random.normal()));
    });
    return result;
}

ObjectFrame withRoundBorder(const ImageF& frame, std::uint64_t seed, double softPx)
{
    CounterRandom random(seed);
    const Vector2d center = middleOf(frame) + 0.04 * sideOf(frame) * Vector2d(random.normal(), random.normal());
    const double radius = random.uniform(0.42, 0.56) * sideOf(frame);
    return {bordered(frame, random, softPx, [&](const Vector2d& at) { return radius - (at - center).norm(); }),
            {circle(center, radius)},
            5.0 + softPx};
}

ObjectFrame withRectangle(const ImageF& frame, std::uint64_t seed, double maxTurnDeg, double softPx)
{
    CounterRandom random(seed);
    const Vector2d center = middleOf(frame);
    const double turn = random.uniform(-maxTurnDeg, maxTurnDeg) * std::numbers::pi / 180.0;
    const Eigen::Rotation2Dd rotation(turn);
    const Vector2d half = Vector2d(random.uniform(0.36, 0.47) * frame.width, random.uniform(0.36, 0.47) * frame.height);
    ObjectFrame object;
    object.frame = bordered(frame, random, softPx, [&](const Vector2d& at) {
        const Vector2d local = rotation.inverse() * (at - center);
        return (half - local.cwiseAbs()).minCoeff();
    });
    const std::vector<Vector2d> corners{{-half.x(), -half.y()}, {half.x(), -half.y()}, half, {-half.x(), half.y()}};
    for (std::size_t k = 0; k < corners.size(); ++k) {
        object.courses.push_back(line(center + rotation * corners[k], center + rotation * corners[(k + 1) % 4]));
    }
    object.reachPx = 5.0 + softPx;
    return object;
}

/// Fills the marked pixels from the gray values around them (Laplace's equation, by relaxation).
ImageF filledIn(ImageF image, const core::Mask2d& marked)
{
    constexpr int rounds = 400;
    const auto at = [&](int x, int y) {
        return image.at(std::clamp(x, 0, image.width - 1), std::clamp(y, 0, image.height - 1));
    };
    for (int round = 0; round < rounds; ++round) {
        test::forEachPixel(image.width, image.height, [&](int x, int y) {
            if (marked.at(x, y) != 0) {
                const float mean = 0.25F * (at(x - 1, y) + at(x + 1, y) + at(x, y - 1) + at(x, y + 1));
                image.at(x, y) += 1.7F * (mean - image.at(x, y));
            }
        });
    }
    return image;
}

}   // namespace

ImageF withoutVessels(const ImageF& frame, const core::Mask2d& vessels, int marginPx, std::uint64_t seed)
{
    CounterRandom random(seed);
    core::Mask2d marked(vessels.width, vessels.height);
    for (int y = 0; y < marked.height; ++y) {
        for (int x = 0; x < marked.width; ++x) {
            for (int dy = -marginPx; dy <= marginPx; ++dy) {
                for (int dx = -marginPx; dx <= marginPx; ++dx) {
                    const bool isVessel = vessels.contains(x + dx, y + dy) && vessels.at(x + dx, y + dy) != 0;
                    marked.at(x, y) = isVessel ? 255 : marked.at(x, y);
                }
            }
        }
    }
    const ImageF slow = core::gaussianBlur(frame, 2.0);
    std::vector<float> grain;
    for (std::size_t i = 0; i < frame.pixels.size(); ++i) {
        if (marked.pixels[i] == 0) {
            grain.push_back(frame.pixels[i] - slow.pixels[i]);
        }
    }
    ImageF result = filledIn(slow, marked);
    for (std::size_t i = 0; i < frame.pixels.size(); ++i) {
        const float own =
            grain.empty() ? 0.0F : grain[static_cast<std::size_t>(random.index(static_cast<int>(grain.size())))];
        result.pixels[i] = marked.pixels[i] != 0 ? result.pixels[i] + own : frame.pixels[i];
    }
    return result;
}

std::vector<ForeignObject> foreignObjects()
{
    using Frame = const ImageF&;
    return {
        {"round border", false, [](Frame f, std::uint64_t seed) { return withRoundBorder(f, seed, 0.5); }},
        {"round border, soft", false, [](Frame f, std::uint64_t seed) { return withRoundBorder(f, seed, 3.0); }},
        {"collimator", false, [](Frame f, std::uint64_t seed) { return withRectangle(f, seed, 0.0, 2.0); }},
        {"turned shutters", false, [](Frame f, std::uint64_t seed) { return withRectangle(f, seed, 20.0, 0.5); }},
        {"turned, soft", false, [](Frame f, std::uint64_t seed) { return withRectangle(f, seed, 20.0, 4.0); }},
        {"letters", false, withText},
        {"clips", false, withClips},
        {"sternal wires", false, withSternalWires},
        {"catheter, filled", true, [](Frame f, std::uint64_t seed) { return withCatheter(f, seed, false); }},
        {"catheter, hollow", true, [](Frame f, std::uint64_t seed) { return withCatheter(f, seed, true); }},
        {"wire", true, withWire},
    };
}

}   // namespace angiopose::test
