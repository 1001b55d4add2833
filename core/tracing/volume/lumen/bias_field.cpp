#include "core/tracing/volume/lumen/bias_field.h"

#include "core/support/quantile.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <vector>

namespace angiopose::core {
namespace {

constexpr double cellMm = 12.0;
constexpr int samplesAlong = 5;   ///< samples per cell, along each axis
constexpr double minTissueToAir = 1.6;   ///< minimum ratio of a tissue cell's median to that of air
constexpr double airQuantile = 0.05;   ///< quantile of the cell medians that is taken as air
constexpr double minOfRange = 0.02;   ///< minimum relative to the brightest cell; darker cells are noise-free air
constexpr std::size_t minCells = 60;
constexpr int coilRounds = 10;
constexpr double maxLogDeviation = 0.7;   ///< maximum log deviation; organs that differ more are ignored
constexpr double coilStiffness = 1e-3;   ///< relative to the number of cells; damps curvature driven by few cells
constexpr double minFallOff = 2.0;
constexpr double maxFallOff = 8.0;   ///< larger corrections would only amplify noise
constexpr double maxScatter = 0.3;   ///< maximum of the median log deviation from the field
constexpr double minExplained = 0.5;   ///< minimum fraction of the tissue's variance explained by the field
constexpr double maxStoredValue = 32000.0;

using Terms = Eigen::Matrix<double, 10, 1>;

/// Returns the polynomial terms of the field; `place` ranges from -1 to 1 along each axis.
Terms termsAt(const Eigen::Vector3d& place)
{
    Terms terms;
    const double x = place.x();
    const double y = place.y();
    const double z = place.z();
    terms << 1.0, x, y, z, x * x, y * y, z * z, x * y, y * z, z * x;
    return terms;
}

struct Cell {
    Eigen::Vector3d place;
    double median = 0.0;
    double logarithm = 0.0;   ///< logarithm of the noise-corrected signal
};

/// Positions and values of a scan in patient axis order.
class CoilScan {
public:
    CoilScan(const Volume& volume, const AxisOrder& order) : volume_(volume), order_(order) {}

    double value(int i, int j, int k) const { return volume_.value(order_.stored(i, j, k)); }

    Eigen::Vector3d placeOf(const Eigen::Vector3d& voxel) const
    {
        const Eigen::Array3d half = 0.5 * (order_.geometry.size.cast<double>().array() - 1.0).max(1.0);
        return (voxel.array() / half - 1.0).matrix();
    }

    std::vector<Cell> cells() const
    {
        const Eigen::Array3i per =
            (cellMm / order_.geometry.spacingMm.array()).round().max(1.0).cast<int>().min(order_.geometry.size.array());
        const Eigen::Array3i count = order_.geometry.size.array() / per;
        std::vector<Cell> found;
        for (int k = 0; k < count.z(); ++k) {
            for (int j = 0; j < count.y(); ++j) {
                for (int i = 0; i < count.x(); ++i) {
                    found.push_back(cellFrom(per * Eigen::Array3i(i, j, k), per));
                }
            }
        }
        return found;
    }

    const AxisOrder& order() const { return order_; }

private:
    Cell cellFrom(const Eigen::Array3i& low, const Eigen::Array3i& per) const
    {
        const Eigen::Array3i step = (per / samplesAlong).max(1);
        std::vector<double> values;
        for (int k = step.z() / 2; k < per.z(); k += step.z()) {
            for (int j = step.y() / 2; j < per.y(); j += step.y()) {
                for (int i = step.x() / 2; i < per.x(); i += step.x()) {
                    values.push_back(value(low.x() + i, low.y() + j, low.z() + k));
                }
            }
        }
        Cell cell;
        cell.place = placeOf((low.cast<double>() + 0.5 * (per.cast<double>() - 1.0)).matrix());
        cell.median = medianOf(std::move(values));
        return cell;
    }

    const Volume& volume_;
    const AxisOrder& order_;
};

/// Returns the cells that contain tissue rather than air.
std::vector<Cell> selectTissueCells(std::vector<Cell> cells)
{
    if (cells.empty()) {
        return {};
    }
    std::ranges::sort(cells, {}, &Cell::median);
    const double air =
        std::max(0.0, cells[static_cast<std::size_t>(airQuantile * static_cast<double>(cells.size()))].median);
    const double minField = std::max(minTissueToAir * air, minOfRange * cells.back().median);
    std::erase_if(cells, [&](const Cell& cell) { return cell.median <= minField; });
    for (Cell& cell : cells) {
        cell.logarithm = 0.5 * std::log(cell.median * cell.median - air * air);
    }
    return cells;
}

Terms fitField(const std::vector<Cell>& cells)
{
    Terms field = Terms::Zero();
    std::vector<double> logarithms;
    for (const Cell& cell : cells) {
        logarithms.push_back(cell.logarithm);
    }
    field[0] = medianOf(std::move(logarithms));
    for (int round = 0; round < coilRounds; ++round) {
        const double reach = maxLogDeviation * (round < coilRounds / 2 ? 2.0 : 1.0);   // initial field is flat
        Eigen::Matrix<double, 10, 10> normal = Eigen::Matrix<double, 10, 10>::Zero();
        Terms right = Terms::Zero();
        for (const Cell& cell : cells) {
            const Terms terms = termsAt(cell.place);
            const double off = (cell.logarithm - field.dot(terms)) / reach;
            const double weight = std::abs(off) < 1.0 ? std::pow(1.0 - off * off, 2) : 0.0;   // Tukey's biweight
            normal += weight * terms * terms.transpose();
            right += weight * cell.logarithm * terms;
        }
        normal.diagonal().tail<9>().array() += coilStiffness * static_cast<double>(cells.size());
        field = normal.ldlt().solve(right);
    }
    return field;
}

/// Range of the field's logarithm over the body.
struct FieldRange {
    double low = 0.0;
    double high = 0.0;
};

std::optional<FieldRange> measureRange(const Terms& field, const std::vector<Cell>& cells)
{
    std::vector<double> fields, deviations;
    double mean = 0.0;
    for (const Cell& cell : cells) {
        fields.push_back(field.dot(termsAt(cell.place)));
        deviations.push_back(std::abs(cell.logarithm - fields.back()));
        mean += cell.logarithm / static_cast<double>(cells.size());
    }
    double all = 0.0;
    double left = 0.0;
    for (const Cell& cell : cells) {
        all += std::min(std::pow(cell.logarithm - mean, 2), std::pow(2.0 * maxLogDeviation, 2));
        left += std::min(std::pow(cell.logarithm - field.dot(termsAt(cell.place)), 2), std::pow(maxLogDeviation, 2));
    }
    std::ranges::sort(fields);
    const auto at = [&](double share) {
        return fields[static_cast<std::size_t>(share * static_cast<double>(fields.size() - 1))];
    };
    const FieldRange reach{at(0.02), at(0.98)};
    const bool isCoil = reach.high - reach.low >= std::log(minFallOff) && left <= (1.0 - minExplained) * all &&
                        medianOf(std::move(deviations)) <= maxScatter;
    return isCoil ? std::optional(reach) : std::nullopt;
}

Volume divideByField(const Terms& field, const FieldRange& reach, const CoilScan& scan, const Volume& volume)
{
    const double minField = std::max(reach.low, reach.high - std::log(maxFallOff));
    const VolumeGeometry& grid = scan.order().geometry;
    const auto forEachCorrected = [&](const auto& visit) {
        for (int k = 0; k < grid.size.z(); ++k) {
            for (int j = 0; j < grid.size.y(); ++j) {
                for (int i = 0; i < grid.size.x(); ++i) {
                    const double here = field.dot(termsAt(scan.placeOf(Eigen::Vector3d(i, j, k))));
                    visit(scan.order().stored(i, j, k),
                          scan.value(i, j, k) * std::exp(reach.high - std::clamp(here, minField, reach.high)));
                }
            }
        }
    };
    double maxValue = 1.0;
    forEachCorrected([&](std::size_t, double value) { maxValue = std::max(maxValue, std::abs(value)); });
    Volume corrected(volume.geometry);
    corrected.slope = std::max(std::abs(volume.slope), maxValue / maxStoredValue);
    forEachCorrected([&](std::size_t voxel, double value) {
        corrected.voxels[voxel] = static_cast<std::int16_t>(std::lround(value / corrected.slope));
    });
    return corrected;
}

}   // namespace

std::optional<BiasCorrectedScan> correctBiasField(const Volume& volume, const AxisOrder& order)
{
    const CoilScan scan(volume, order);
    const std::vector<Cell> tissue = selectTissueCells(scan.cells());
    if (tissue.size() < minCells) {
        return {};
    }
    const Terms field = fitField(tissue);
    const std::optional<FieldRange> reach = measureRange(field, tissue);
    if (!reach) {
        return {};
    }
    return BiasCorrectedScan{divideByField(field, *reach, scan, volume), std::exp(reach->high - reach->low)};
}

}   // namespace angiopose::core
