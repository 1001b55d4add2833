#pragma once

#include <array>
#include <cmath>
#include <cstddef>

namespace angiopose::core {

/// Function of s as a Taylor series about 0, up to s⁴.
struct PowerSeries {
    static constexpr std::size_t terms = 5;
    std::array<double, terms> at{};   ///< at[k] is the coefficient of sᵏ

    PowerSeries& operator+=(const PowerSeries& other)
    {
        for (std::size_t k = 0; k < terms; ++k) {
            at[k] += other.at[k];
        }
        return *this;
    }

    double value(double s) const { return at[0] + s * (at[1] + s * (at[2] + s * (at[3] + s * at[4]))); }
    double slope(double s) const { return at[1] + s * (2.0 * at[2] + s * (3.0 * at[3] + s * 4.0 * at[4])); }
};

inline PowerSeries operator*(double factor, PowerSeries series)
{
    for (double& coefficient : series.at) {
        coefficient *= factor;
    }
    return series;
}

inline PowerSeries operator*(const PowerSeries& a, const PowerSeries& b)
{
    PowerSeries product;
    for (std::size_t n = 0; n < PowerSeries::terms; ++n) {
        for (std::size_t k = 0; k <= n; ++k) {
            product.at[n] += a.at[k] * b.at[n - k];
        }
    }
    return product;
}

/// Divides two series; `b` must not vanish at 0.
inline PowerSeries operator/(const PowerSeries& a, const PowerSeries& b)
{
    PowerSeries quotient;
    for (std::size_t n = 0; n < PowerSeries::terms; ++n) {
        double rest = a.at[n];
        for (std::size_t k = 1; k <= n; ++k) {
            rest -= b.at[k] * quotient.at[n - k];
        }
        quotient.at[n] = rest / b.at[0];
    }
    return quotient;
}

/// Returns the series of e = exp(a), from e' = a' e.
inline PowerSeries exp(const PowerSeries& a)
{
    PowerSeries e;
    e.at[0] = std::exp(a.at[0]);
    for (std::size_t n = 1; n < PowerSeries::terms; ++n) {
        for (std::size_t k = 1; k <= n; ++k) {
            e.at[n] += static_cast<double>(k) * a.at[k] * e.at[n - k];
        }
        e.at[n] /= static_cast<double>(n);
    }
    return e;
}

}   // namespace angiopose::core
