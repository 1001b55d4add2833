#include "core/geometry/geometry_checks.h"

#include "core/messages/messages.h"

#include <cmath>

namespace angiopose::core {
namespace {

// Plausible C-arm ranges: a value outside them is mistyped, in another unit, or from another type of machine.
constexpr double minSidMm = 500.0, maxSidMm = 2000.0;
constexpr double maxMagnification = 2.5;
constexpr double minDetectorSpacingMm = 0.05, maxSpacingMm = 2.0;
constexpr double minDetectorMm = 60.0, maxDetectorMm = 700.0;

// Tolerances between two sources of the same length; header values are rounded.
constexpr double sameLength = 0.05;
constexpr double sameMagnification = 0.02;
constexpr double sameAspect = 0.01;

bool isKnownPositive(const SourcedValue<double>& sourced)
{
    return sourced.value && std::isfinite(*sourced.value) && *sourced.value > 0.0;
}

bool differ(double a, double b, double share)
{
    return std::abs(a - b) > share * std::abs(b);
}

/// Collects the messages; each check reports one problem.
class GeometryChecker {
public:
    GeometryChecker(const CArm& cArm, const GantryHeader& header, const Eigen::Vector2i& imageSizePx)
        : cArm_(cArm), header_(header), sizePx_(imageSizePx)
    {
    }

    Messages run()
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
    void reportIf(bool isWrong, Message message)
    {
        if (isWrong) {
            found_.push_back(std::move(message));
        }
    }
    bool hasSpacing() const { return isKnownPositive(cArm_.columnSpacingMm) && isKnownPositive(cArm_.rowSpacingMm); }
    bool hasDistances() const
    {
        return isKnownPositive(cArm_.sourceToDetectorMm) && isKnownPositive(vesselDepthOf(cArm_));
    }
    /// Returns the magnification at the vessels.
    double magnification() const { return *cArm_.sourceToDetectorMm.value / *vesselDepthOf(cArm_).value; }

    void checkDistances()
    {
        if (isKnownPositive(cArm_.sourceToDetectorMm)) {
            const double sid = *cArm_.sourceToDetectorMm.value;
            reportIf(sid < minSidMm || sid > maxSidMm, messages::sidUnusual(inMm(sid, 0)));
        }
        if (hasDistances()) {
            const double sod = std::max(*vesselDepthOf(cArm_).value, cArm_.sourceToIsocenterMm.value.value_or(0.0));
            reportIf(sod >= *cArm_.sourceToDetectorMm.value,
                     messages::sodBeyondSid(inMm(sod, 0), inMm(*cArm_.sourceToDetectorMm.value, 0)));
            reportIf(magnification() > maxMagnification, messages::magnificationUnusual(Quantity{magnification(), 2}));
        }
    }

    void checkMagnification()
    {
        // Distances entered by the user take precedence over the header.
        const bool areTyped =
            cArm_.sourceToDetectorMm.origin == Origin::User || vesselDepthOf(cArm_).origin == Origin::User;
        if (hasDistances() && header_.magnification && !areTyped) {
            reportIf(
                differ(magnification(), *header_.magnification, sameMagnification),
                messages::magnificationInconsistent(Quantity{*header_.magnification, 3}, Quantity{magnification(), 3}));
        }
    }

    void checkSpacing()
    {
        if (!hasSpacing()) {
            return;
        }
        const double column = *cArm_.columnSpacingMm.value, row = *cArm_.rowSpacingMm.value;
        reportIf(std::min(row, column) < minDetectorSpacingMm || std::max(row, column) > maxSpacingMm,
                 messages::spacingUnusual(inMm(column, 4)));
        reportIf(differ(row / column, header_.pixelAspect, sameAspect),
                 messages::aspectDiffers(Quantity{row / column, 3}, Quantity{header_.pixelAspect, 3}));
    }

    void checkExtent()
    {
        if (!hasSpacing() || sizePx_.minCoeff() <= 0) {
            return;
        }
        const Eigen::Vector2d extentMm(sizePx_.x() * *cArm_.columnSpacingMm.value,
                                       sizePx_.y() * *cArm_.rowSpacingMm.value);
        const Message covers = messages::imageCovers(Quantity{extentMm.x()}, inMm(extentMm.y(), 0));
        reportIf(extentMm.maxCoeff() < minDetectorMm || extentMm.maxCoeff() > maxDetectorMm,
                 messages::extentUnlikeDetector(covers));
        if (const auto& field = header_.fieldOfViewMm) {
            reportIf(differ(extentMm.x(), field->x(), sameLength) || differ(extentMm.y(), field->y(), sameLength),
                     messages::extentUnlikeField(covers, Quantity{field->x()}, inMm(field->y(), 0)));
        }
        if (const auto& intensifier = header_.intensifierMm) {
            reportIf(extentMm.maxCoeff() > (1.0 + sameLength) * *intensifier,
                     messages::extentBeyondIntensifier(covers, inMm(*intensifier, 0)));
        }
        if (const auto& detector = header_.detectorMm) {
            reportIf((extentMm - (1.0 + sameLength) * *detector).maxCoeff() > 0.0,
                     messages::extentBeyondDetector(covers, Quantity{detector->x()}, inMm(detector->y(), 0)));
        }
    }

    /// Checks the pixel spacing (0028,0030) against the imager spacing: at the object plane if calibrated, else
    /// directly.
    void checkCalibration()
    {
        if (!header_.pixelSpacingMm || !hasSpacing()) {
            return;
        }
        const double column = *cArm_.columnSpacingMm.value, pixel = header_.pixelSpacingMm->x();
        if (header_.isPixelSpacingCalibrated && hasDistances()) {
            reportIf(differ(pixel * magnification(), column, 2.0 * sameLength),
                     messages::calibrationOff(inMm(pixel, 4), inMm(pixel * magnification(), 4), inMm(column, 4)));
        } else if (!header_.isPixelSpacingCalibrated) {
            reportIf(differ(pixel, column, sameLength), messages::spacingsDiffer(inMm(pixel, 4), inMm(column, 4)));
        }
    }

    void checkAngles()
    {
        const auto outside = [](const SourcedValue<double>& angle, double limitDeg) {
            return angle.value && !(std::abs(*angle.value) <= limitDeg);
        };
        reportIf(outside(cArm_.primaryAngleDeg, 180.0), messages::primaryAngleOutside());
        reportIf(outside(cArm_.secondaryAngleDeg, 90.0), messages::secondaryAngleOutside());
        reportIf(outside(cArm_.rollDeg, 180.0), messages::rollOutside());
    }

    void checkPrincipalPoint()
    {
        const auto& point = cArm_.principalPointPx.value;
        if (!point || sizePx_.minCoeff() <= 0) {
            return;
        }
        const bool isInside =
            point->x() >= 0.0 && point->y() >= 0.0 && point->x() < sizePx_.x() && point->y() < sizePx_.y();
        reportIf(!isInside, messages::principalPointOutside(Quantity{point->x()}, Quantity{point->y(), 0, "px"}));
    }

    const CArm& cArm_;
    const GantryHeader& header_;
    Eigen::Vector2i sizePx_;
    Messages found_;
};

}   // namespace

Messages findContradictions(const CArm& cArm, const GantryHeader& header, const Eigen::Vector2i& imageSizePx)
{
    return GeometryChecker(cArm, header, imageSizePx).run();
}

Messages findMissingGeometry(const CArm& cArm)
{
    Messages missing;
    const auto requireValue = [&missing](bool isThere, const auto& message) {
        if (!isThere) {
            missing.push_back(message().as(Severity::Note));
        }
    };
    requireValue(isKnownPositive(cArm.sourceToDetectorMm), messages::askSid);
    requireValue(isKnownPositive(cArm.sourceToIsocenterMm), messages::askSod);
    requireValue(isKnownPositive(cArm.columnSpacingMm) && isKnownPositive(cArm.rowSpacingMm), messages::askSpacing);
    requireValue(cArm.primaryAngleDeg.value.has_value(), messages::askPrimaryAngle);
    requireValue(cArm.secondaryAngleDeg.value.has_value(), messages::askSecondaryAngle);
    return missing;
}

}   // namespace angiopose::core
