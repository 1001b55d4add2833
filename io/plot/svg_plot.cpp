#include "io/plot/svg_plot.h"

#include "core/support/format_number.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace angiopose::io {
namespace {

constexpr double maxTicks = 8.0;

/// Formats a power of ten: 0.01 to 1000 in full ("0.01", "1000"), others with exponent ("1e-4").
std::string powerOfTen(int exponent)
{
    return exponent >= -2 && exponent <= 3 ? core::plainText(std::pow(10.0, exponent))
                                           : "1e" + std::to_string(exponent);
}

/// Returns the step that divides `range` into a suitable number of ticks: 1, 2 or 5 times a power of ten.
double roundStep(double range)
{
    const double power = std::pow(10.0, std::floor(std::log10(range / maxTicks)));
    for (const double factor : {1.0, 2.0, 5.0}) {
        if (range / (factor * power) <= maxTicks) {
            return factor * power;
        }
    }
    return 10.0 * power;
}

std::vector<PlotTick> linearTicks(const core::PlotAxis& axis)
{
    const double step = roundStep(axis.max - axis.min);
    std::vector<PlotTick> ticks;
    const double first = std::ceil(axis.min / step - 1e-9) + 0.0;   // avoids −0
    for (double k = first; k * step <= axis.max + 1e-9 * step; k += 1.0) {
        ticks.push_back({k * step, core::plainText(k * step)});
    }
    return ticks;
}

std::vector<PlotTick> logarithmicTicks(const core::PlotAxis& axis)
{
    const int first = static_cast<int>(std::ceil(std::log10(axis.min) - 1e-9));
    const int last = static_cast<int>(std::floor(std::log10(axis.max) + 1e-9));
    const int stride = std::max(1, static_cast<int>(std::ceil((last - first + 1) / maxTicks)));
    std::vector<PlotTick> ticks;
    for (int exponent = first; exponent <= last; exponent += stride) {
        ticks.push_back({std::pow(10.0, exponent), powerOfTen(exponent)});
    }
    return ticks;
}

constexpr double plotLeft = 74.0;
constexpr double plotTop = 44.0;
constexpr double plotWidth = 520.0;
constexpr double plotHeight = 320.0;
constexpr double bottomMargin = 56.0;
constexpr double legendGap = 24.0;
constexpr double legendLine = 20.0;
constexpr double legendSample = 26.0;
constexpr double characterWidth = 6.6;   // approximate width of a character in the legend, px

/// Color-blind-safe palette (Okabe and Ito 2008); the first color is for the method under evaluation.
constexpr std::array colors{"#0072b2", "#d55e00", "#009e73", "#cc79a7", "#8a6d00", "#56b4e9", "#e69f00", "#555555"};
constexpr std::array dashes{"", "7 3", "2 3", "9 3 2 3"};   // next dash pattern once all colors have been used

std::string number(double value)
{
    return core::fixedText(value, 2);
}

std::string escapedXml(const std::string& text)
{
    std::string result;
    for (const char c : text) {
        result += c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '>' ? "&gt;" : c == '"' ? "&quot;" : std::string(1, c);
    }
    return result;
}

std::string textAt(double x, double y, const std::string& attributes, const std::string& text)
{
    return "<text x=\"" + number(x) + "\" y=\"" + number(y) + "\" " + attributes + ">" + escapedXml(text) + "</text>\n";
}

std::string lineFrom(double x1, double y1, double x2, double y2, const std::string& attributes)
{
    return "<line x1=\"" + number(x1) + "\" y1=\"" + number(y1) + "\" x2=\"" + number(x2) + "\" y2=\"" + number(y2) +
           "\" " + attributes + "/>\n";
}

std::string strokeOf(std::size_t index)
{
    const std::string dash = dashes[index / colors.size() % dashes.size()];
    return "fill=\"none\" stroke=\"" + std::string(colors[index % colors.size()]) +
           "\" stroke-width=\"2\" stroke-linejoin=\"round\"" +
           (dash.empty() ? "" : " stroke-dasharray=\"" + dash + "\"");
}

/// Draws the elements of one plot.
class SvgPlot {
public:
    explicit SvgPlot(const core::Plot& plot)
        : plot_(plot), x_(plot.x, plotLeft, plotLeft + plotWidth), y_(plot.y, plotTop + plotHeight, plotTop)
    {
    }

    std::string draw() const
    {
        const double height = std::max(plotTop + plotHeight + bottomMargin,
                                       plotTop + legendLine * static_cast<double>(plot_.series.size()) + 10.0);
        const std::string size = "width=\"" + number(widthPx()) + "\" height=\"" + number(height) + "\"";
        return "<svg xmlns=\"http://www.w3.org/2000/svg\" " + size + " viewBox=\"0 0 " + number(widthPx()) + " " +
               number(height) + "\" font-family=\"Inter, Helvetica, Arial, sans-serif\" font-size=\"12\">\n" +
               "<rect " + size + " fill=\"#ffffff\"/>\n" + grid() + frame() + series() + legend() + "</svg>\n";
    }

private:
    double widthPx() const
    {
        std::size_t longest = 0;
        for (const core::PlotSeries& line : plot_.series) {
            longest = std::max(longest, line.name.size());
        }
        return plotLeft + plotWidth + legendGap + legendSample + 8.0 + characterWidth * static_cast<double>(longest) +
               12.0;
    }

    std::string grid() const
    {
        std::string text;
        const std::string stroke = "stroke=\"#e3e6ea\" stroke-width=\"1\"";
        for (const PlotTick& tick : x_.ticks()) {
            const double x = x_.position(tick.value);
            text += lineFrom(x, plotTop, x, plotTop + plotHeight, stroke);
            text += textAt(x, plotTop + plotHeight + 18.0, "text-anchor=\"middle\" fill=\"#444\"", tick.label);
        }
        for (const PlotTick& tick : y_.ticks()) {
            const double y = y_.position(tick.value);
            text += lineFrom(plotLeft, y, plotLeft + plotWidth, y, stroke);
            text += textAt(plotLeft - 8.0, y + 4.0, "text-anchor=\"end\" fill=\"#444\"", tick.label);
        }
        return text;
    }

    std::string series() const
    {
        std::string text;
        for (std::size_t k = 0; k < plot_.series.size(); ++k) {
            text += band(plot_.series[k], k);
        }
        for (std::size_t k = plot_.series.size(); k-- > 0;) {   // draws the first series on top
            text += plot_.series[k].isScatter ? dots(plot_.series[k], k) : polyline(plot_.series[k], k);
        }
        return text;
    }

    std::string point(double x, double y) const { return number(x_.position(x)) + "," + number(y_.position(y)); }

    std::string polyline(const core::PlotSeries& line, std::size_t index) const
    {
        std::string points;
        for (const Eigen::Vector2d& at : line.points) {
            if (at.allFinite()) {
                points += (points.empty() ? "" : " ") + point(at.x(), at.y());
            }
        }
        return "<polyline points=\"" + points + "\" " + strokeOf(index) + "/>\n";
    }

    std::string dots(const core::PlotSeries& cloud, std::size_t index) const
    {
        std::string text;
        for (const Eigen::Vector2d& at : cloud.points) {
            if (at.allFinite()) {
                text += dot(x_.position(at.x()), y_.position(at.y()), index);
            }
        }
        return text;
    }

    static std::string dot(double x, double y, std::size_t index)
    {
        return "<circle cx=\"" + number(x) + "\" cy=\"" + number(y) + "\" r=\"3.5\" fill=\"" +
               std::string(colors[index % colors.size()]) + "\" fill-opacity=\"0.75\"/>\n";
    }

    std::string band(const core::PlotSeries& line, std::size_t index) const
    {
        if (line.bands.size() != line.points.size() || line.bands.empty()) {
            return "";
        }
        std::string points;
        for (std::size_t k = 0; k < line.bands.size(); ++k) {
            points += point(line.points[k].x(), line.bands[k].high) + " ";
        }
        for (std::size_t k = line.bands.size(); k-- > 0;) {
            points += point(line.points[k].x(), line.bands[k].low) + " ";
        }
        return "<polygon points=\"" + points + "\" fill=\"" + std::string(colors[index % colors.size()]) +
               "\" fill-opacity=\"0.08\"/>\n";
    }

    std::string frame() const
    {
        const double middleX = plotLeft + 0.5 * plotWidth;
        const double middleY = plotTop + 0.5 * plotHeight;
        return "<rect x=\"" + number(plotLeft) + "\" y=\"" + number(plotTop) + "\" width=\"" + number(plotWidth) +
               "\" height=\"" + number(plotHeight) + "\" fill=\"none\" stroke=\"#8a9099\"/>\n" +
               textAt(plotLeft, plotTop - 16.0, "font-size=\"14\" font-weight=\"600\" fill=\"#111\"", plot_.title) +
               textAt(middleX, plotTop + plotHeight + 42.0, "text-anchor=\"middle\" fill=\"#111\"", plot_.x.label) +
               textAt(0.0, 0.0,
                      "text-anchor=\"middle\" fill=\"#111\" transform=\"translate(20 " + number(middleY) +
                          ") rotate(-90)\"",
                      plot_.y.label);
    }

    std::string legend() const
    {
        std::string text;
        const double x = plotLeft + plotWidth + legendGap;
        for (std::size_t k = 0; k < plot_.series.size(); ++k) {
            const double y = plotTop + 10.0 + legendLine * static_cast<double>(k);
            text += plot_.series[k].isScatter ? dot(x + 0.5 * legendSample, y, k)
                                              : lineFrom(x, y, x + legendSample, y, strokeOf(k));
            text += textAt(x + legendSample + 8.0, y + 4.0, "fill=\"#111\"", plot_.series[k].name);
        }
        return text;
    }

    const core::Plot& plot_;
    PlotScale x_;
    PlotScale y_;
};

}   // namespace

double PlotScale::position(double value) const
{
    const auto along = [this](double v) { return axis_.isLogarithmic ? std::log10(v) : v; };
    const double clipped = std::clamp(value, axis_.min, axis_.max);
    return from_ + (to_ - from_) * (along(clipped) - along(axis_.min)) / (along(axis_.max) - along(axis_.min));
}

std::vector<PlotTick> PlotScale::ticks() const
{
    if (!(axis_.max > axis_.min)) {
        return {};
    }
    return axis_.isLogarithmic ? logarithmicTicks(axis_) : linearTicks(axis_);
}

std::string toSvg(const core::Plot& plot)
{
    return SvgPlot(plot).draw();
}

}   // namespace angiopose::io
