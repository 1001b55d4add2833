#include "core/geometry/geometry_checks.h"

#include <array>
#include <cmath>
#include <cstdio>

namespace angiopose::core {
namespace {

// What C-arms are like: outside, a value is a misprint, another unit, or of another machine.
constexpr double leastSidMm = 500.0, mostSidMm = 2000.0;
constexpr double mostMagnification = 2.5;
constexpr double leastDetectorSpacingMm = 0.05, mostSpacingMm = 2.0;
constexpr double leastDetectorMm = 60.0, mostDetectorMm = 700.0;

// Headers round: how far two accounts of one length may differ.
constexpr double sameLength = 0.05;
constexpr double sameMagnification = 0.02;
constexpr double sameAspect = 0.01;

bool isKnownPositive(const Sourced<double>& sourced)
{
    return sourced.value && std::isfinite(*sourced.value) && *sourced.value > 0.0;
}

bool differ(double a, double b, double share)
{
    return std::abs(a - b) > share * std::abs(b);
}

std::string text(double value, int decimals)
{
    std::array<char, 48> buffer{};
    std::snprintf(buffer.data(), buffer.size(), "%.*f", decimals, value);
    return buffer.data();
}

/// Collects sentences; each check says one thing.
class Checks {
public:
    Checks(const CArm& cArm, const GantryHeader& header, const Eigen::Vector2i& imageSizePx)
        : cArm_(cArm), header_(header), sizePx_(imageSizePx)
    {
    }

    std::vector<std::string> run()
    {
        checkDistances();
        checkMagnification();
        checkSpacing();
        checkExtent();
        checkCalibration();
        checkAngles();
        checkPrincipalPoint();
        return std::move(found_);
    }

private:
    void say(bool isWrong, const std::string& sentence)
    {
        if (isWrong) {
            found_.push_back(sentence);
        }
    }
    bool hasSpacing() const { return isKnownPositive(cArm_.columnSpacingMm) && isKnownPositive(cArm_.rowSpacingMm); }
    bool hasDistances() const
    {
        return isKnownPositive(cArm_.sourceToDetectorMm) && isKnownPositive(cArm_.sourceToPatientMm);
    }
    double magnification() const { return *cArm_.sourceToDetectorMm.value / *cArm_.sourceToPatientMm.value; }

    void checkDistances()
    {
        if (isKnownPositive(cArm_.sourceToDetectorMm)) {
            const double sid = *cArm_.sourceToDetectorMm.value;
            say(sid < leastSidMm || sid > mostSidMm, "A source to detector distance (SID) of " + text(sid, 0) +
                                                         " mm is unlike a C-arm (500 to 2000 mm): check its unit.");
        }
        if (hasDistances()) {
            say(magnification() <= 1.0, "SOD (" + text(*cArm_.sourceToPatientMm.value, 0) +
                                            " mm) is not smaller than SID (" +
                                            text(*cArm_.sourceToDetectorMm.value, 0) +
                                            " mm): the patient would lie behind the detector. Correct one of them.");
            say(magnification() > mostMagnification, "SID is " + text(magnification(), 2) +
                                                         " times SOD; angiograms are magnified 1.0 to 2.5 times. "
                                                         "Check both distances.");
        }
    }

    void checkMagnification()
    {
        // Who types a distance knows better than the header.
        const bool areTyped =
            cArm_.sourceToDetectorMm.origin == Origin::User || cArm_.sourceToPatientMm.origin == Origin::User;
        if (hasDistances() && header_.magnification && !areTyped) {
            say(differ(magnification(), *header_.magnification, sameMagnification),
                "The header's magnification of " + text(*header_.magnification, 3) + " (0018,1114) is not SID/SOD = " +
                    text(magnification(), 3) + ": one of the three is stale. Check SID and SOD.");
        }
    }

    void checkSpacing()
    {
        if (!hasSpacing()) {
            return;
        }
        const double column = *cArm_.columnSpacingMm.value, row = *cArm_.rowSpacingMm.value;
        say(std::min(row, column) < leastDetectorSpacingMm || std::max(row, column) > mostSpacingMm,
            "A detector pixel spacing of " + text(column, 4) + " mm lies outside 0.05 to 2 mm: check its unit.");
        say(differ(row / column, header_.pixelAspect, sameAspect),
            "Pixels are " + text(row / column, 3) + " times as high as wide by their spacing, " +
                text(header_.pixelAspect, 3) + " times by the pixel aspect: check the pixel spacing.");
    }

    void checkExtent()
    {
        if (!hasSpacing() || sizePx_.minCoeff() <= 0) {
            return;
        }
        const Eigen::Vector2d extentMm(sizePx_.x() * *cArm_.columnSpacingMm.value,
                                       sizePx_.y() * *cArm_.rowSpacingMm.value);
        const std::string covers = "The image covers " + text(extentMm.x(), 0) + " x " + text(extentMm.y(), 0) +
                                   " mm of the detector by its pixel spacing";
        say(extentMm.maxCoeff() < leastDetectorMm || extentMm.maxCoeff() > mostDetectorMm,
            covers + ": no detector of a C-arm is like that. Check the pixel spacing.");
        if (const auto& field = header_.fieldOfViewMm) {
            say(differ(extentMm.x(), field->x(), sameLength) || differ(extentMm.y(), field->y(), sameLength),
                covers + ", the field of view is " + text(field->x(), 0) + " x " + text(field->y(), 0) +
                    " mm: the image may be zoomed, cropped or resampled. Check the pixel spacing.");
        }
        if (const auto& intensifier = header_.intensifierMm) {
            say(extentMm.maxCoeff() > (1.0 + sameLength) * *intensifier,
                covers + ", more than the intensifier of " + text(*intensifier, 0) + " mm. Check the pixel spacing.");
        }
        if (const auto& detector = header_.detectorMm) {
            say((extentMm - (1.0 + sameLength) * *detector).maxCoeff() > 0.0,
                covers + ", more than its active " + text(detector->x(), 0) + " x " + text(detector->y(), 0) +
                    " mm. Check the pixel spacing.");
        }
    }

    /// Pixel spacing (0028,0030) is of the object plane once it is calibrated; else it repeats the imager's.
    void checkCalibration()
    {
        if (!header_.pixelSpacingMm || !hasSpacing()) {
            return;
        }
        const double column = *cArm_.columnSpacingMm.value, pixel = header_.pixelSpacingMm->x();
        if (header_.isPixelSpacingCalibrated && hasDistances()) {
            say(differ(pixel * magnification(), column, 2.0 * sameLength),
                "The calibrated pixel spacing of " + text(pixel, 4) + " mm times SID/SOD is " +
                    text(pixel * magnification(), 4) + " mm, not the detector's " + text(column, 4) +
                    " mm: the calibration or a distance is off.");
        } else if (!header_.isPixelSpacingCalibrated) {
            say(differ(pixel, column, sameLength), "Pixel Spacing (0028,0030) says " + text(pixel, 4) +
                                                       " mm without a calibration, the detector's pixels are " +
                                                       text(column, 4) + " mm: check which is meant.");
        }
    }

    void checkAngles()
    {
        const auto outside = [](const Sourced<double>& angle, double limitDeg) {
            return angle.value && !(std::abs(*angle.value) <= limitDeg);
        };
        say(outside(cArm_.primaryAngleDeg, 180.0), "The primary angle (LAO/RAO) lies outside ±180°. Correct it.");
        say(outside(cArm_.secondaryAngleDeg, 90.0), "The secondary angle (CRA/CAU) lies outside ±90°. Correct it.");
        say(outside(cArm_.rollDeg, 180.0), "The roll lies outside ±180°. Correct it.");
    }

    void checkPrincipalPoint()
    {
        const auto& point = cArm_.principalPointPx.value;
        if (!point || sizePx_.minCoeff() <= 0) {
            return;
        }
        const bool isInside =
            point->x() >= 0.0 && point->y() >= 0.0 && point->x() < sizePx_.x() && point->y() < sizePx_.y();
        say(!isInside, "The principal point (" + text(point->x(), 0) + ", " + text(point->y(), 0) +
                           " px) lies outside the image: right for a cropped image only.");
    }

    const CArm& cArm_;
    const GantryHeader& header_;
    Eigen::Vector2i sizePx_;
    std::vector<std::string> found_;
};

}   // namespace

std::vector<std::string> findContradictions(const CArm& cArm, const GantryHeader& header,
                                            const Eigen::Vector2i& imageSizePx)
{
    return Checks(cArm, header, imageSizePx).run();
}

std::vector<std::string> findMissing(const CArm& cArm)
{
    std::vector<std::string> missing;
    const auto ask = [&missing](bool isThere, const char* sentence) {
        if (!isThere) {
            missing.emplace_back(sentence);
        }
    };
    ask(isKnownPositive(cArm.sourceToDetectorMm),
        "Source to detector distance (SID): type it, usually 900 to 1200 mm.");
    ask(isKnownPositive(cArm.sourceToPatientMm), "Source to isocentre distance (SOD): type it, usually 700 to 800 mm.");
    ask(isKnownPositive(cArm.columnSpacingMm) && isKnownPositive(cArm.rowSpacingMm),
        "Detector pixel spacing: type it, or the width of the field of view on the detector divided by the columns.");
    ask(cArm.primaryAngleDeg.value.has_value(), "LAO/RAO angle: type it, or place the vessels by landmarks.");
    ask(cArm.secondaryAngleDeg.value.has_value(), "CRA/CAU angle: type it, or place the vessels by landmarks.");
    return missing;
}

}   // namespace angiopose::core