#include "core/evaluation/own/observer_agreement.h"

#include "core/evaluation/trial/projection_error.h"
#include "core/geometry/angle_units.h"

#include <cmath>
#include <map>
#include <set>

namespace angiopose::core {
namespace {

using Measures = Eigen::Matrix<double, poseMeasureCount, 1>;

Measures measuresOf(const ObserverReading& reading, const RigidTransform& reference)
{
    const Vector6d error = errorAboutCentroid(reading.pivotInPatient, {reading.cameraFromPatient, reference});
    Measures measures;
    measures << error.tail<3>(), error.head<3>() * degreesPerRadian;
    return measures;
}

ObserverMean meanOf(const std::vector<Measures>& readings)
{
    ObserverMean result;
    result.count = static_cast<int>(readings.size());
    result.mean.setZero();
    result.variance.setZero();
    for (const Measures& reading : readings) {
        result.mean += reading / result.count;
    }
    for (const Measures& reading : readings) {
        if (result.count > 1) {
            result.variance += (reading - result.mean).cwiseAbs2() / (result.count - 1);
        }
    }
    return result;
}

/// Returns the means of one measure by image and observer.
std::map<std::string, std::map<std::string, double>> meansByImage(const std::vector<ObserverMean>& means,
                                                                  std::size_t measure)
{
    std::map<std::string, std::map<std::string, double>> result;
    for (const ObserverMean& mean : means) {
        result[mean.image][mean.observer] = mean.mean(static_cast<Eigen::Index>(measure));
    }
    return result;
}

}   // namespace

const std::array<PoseMeasure, poseMeasureCount>& poseMeasures()
{
    static constexpr std::array<PoseMeasure, poseMeasureCount> rows{{{"x", "along image rows", "mm"},
                                                                     {"y", "along image columns", "mm"},
                                                                     {"depth", "along the ray", "mm"},
                                                                     {"tilt-x", "tilt about rows", "°"},
                                                                     {"tilt-y", "tilt about columns", "°"},
                                                                     {"roll", "roll", "°"}}};
    return rows;
}

std::vector<ObserverMean> observerMeans(const std::vector<ObserverReading>& readings)
{
    std::map<std::string, RigidTransform> references;
    std::map<std::pair<std::string, std::string>, std::vector<Measures>> groups;
    for (const ObserverReading& reading : readings) {
        const RigidTransform& reference =
            references.try_emplace(reading.image, reading.referenceCameraFromPatient).first->second;
        groups[{reading.image, reading.observer}].push_back(measuresOf(reading, reference));
    }
    std::vector<ObserverMean> means;
    for (const auto& [place, group] : groups) {
        means.push_back(meanOf(group));
        means.back().image = place.first;
        means.back().observer = place.second;
    }
    return means;
}

std::optional<Repeatability> repeatabilityOf(const std::vector<ObserverMean>& means, const std::string& observer,
                                             std::size_t measure)
{
    Repeatability result;
    double squares = 0.0;
    for (const ObserverMean& mean : means) {
        if (mean.observer == observer && mean.count > 1) {
            ++result.images;
            result.readings += mean.count;
            squares += mean.variance(static_cast<Eigen::Index>(measure)) * (mean.count - 1);
        }
    }
    if (result.images == 0) {
        return std::nullopt;
    }
    result.withinStd = std::sqrt(squares / (result.readings - result.images));
    result.coefficient = 1.96 * std::sqrt(2.0) * result.withinStd;
    return result;
}

std::optional<LimitsOfAgreement> agreementOf(const std::vector<ObserverMean>& means, const std::string& first,
                                             const std::string& second, std::size_t measure)
{
    LimitsOfAgreement result;
    for (const auto& [image, byObserver] : meansByImage(means, measure)) {
        const auto a = byObserver.find(first);
        const auto b = byObserver.find(second);
        if (a != byObserver.end() && b != byObserver.end()) {
            result.points.emplace_back(0.5 * (a->second + b->second), a->second - b->second);
        }
    }
    const auto count = static_cast<double>(result.points.size());
    if (result.points.size() < 2) {
        return std::nullopt;
    }
    for (const Eigen::Vector2d& point : result.points) {
        result.bias += point.y() / count;
    }
    double squares = 0.0;
    for (const Eigen::Vector2d& point : result.points) {
        squares += (point.y() - result.bias) * (point.y() - result.bias);
    }
    result.stdDeviation = std::sqrt(squares / (count - 1.0));
    result.biasError = result.stdDeviation / std::sqrt(count);
    result.limitError = result.stdDeviation * std::sqrt(3.0 / count);
    return result;
}

std::optional<Reproducibility> reproducibilityOf(const std::vector<ObserverMean>& means, std::size_t measure)
{
    Reproducibility result;
    double squares = 0.0;
    double freedom = 0.0;
    for (const auto& [image, byObserver] : meansByImage(means, measure)) {
        const auto count = static_cast<double>(byObserver.size());
        double mean = 0.0;
        for (const auto& [observer, value] : byObserver) {
            mean += value / count;
        }
        for (const auto& [observer, value] : byObserver) {
            squares += (value - mean) * (value - mean);
        }
        freedom += count - 1.0;
        result.images += byObserver.size() > 1 ? 1 : 0;
    }
    if (result.images == 0) {
        return std::nullopt;
    }
    result.betweenStd = std::sqrt(squares / freedom);
    return result;
}

std::vector<std::string> observersOf(const std::vector<ObserverMean>& means)
{
    std::set<std::string> names;
    for (const ObserverMean& mean : means) {
        names.insert(mean.observer);
    }
    return {names.begin(), names.end()};
}

}   // namespace angiopose::core
