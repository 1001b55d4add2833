#include "app/review/brightness_memory.h"

#include "app/preferences/private_mode.h"
#include "app/preferences/settings.h"
#include "ui/views/angiogram_view.h"

#include <QCryptographicHash>

#include <algorithm>

namespace angiopose::app {
namespace {

using namespace std::chrono_literals;

constexpr qsizetype keptSeries = 200;

/// Returns the hashed key of a series; it is hashed because settings must not identify patients.
QString seriesKey(const core::View& view)
{
    if (!view.angiogram) {
        return {};
    }
    const std::string& uid = view.angiogram->identity.seriesUid;
    const std::string& known = uid.empty() ? view.imageFile.sha256 : uid;
    const QByteArray text(known.data(), static_cast<qsizetype>(known.size()));
    return known.empty() ? QString()
                         : QString::fromLatin1(QCryptographicHash::hash(text, QCryptographicHash::Sha1).toHex());
}

/// Returns the display range of the peak-opacification frame, independent of the case's current frame.
std::optional<core::DisplayRange> automaticRange(const core::View& view)
{
    if (!view.angiogram || view.angiogram->frames.empty()) {
        return std::nullopt;
    }
    const core::Angiogram& run = *view.angiogram;
    const int peak = std::clamp(run.suggestedFrame, 0, run.frameCount() - 1);
    return core::displayRange(run.frames[static_cast<std::size_t>(peak)]);
}

/// Does nothing in private mode, because anyone with the image could recognize its hash in the settings.
void storeBrightness(const QStringList& remembered)
{
    if (!isPrivate()) {
        settings::brightness.write(remembered);
    }
}

}   // namespace

BrightnessMemory::BrightnessMemory(const CaseDocument& document, ui::AngiogramView& view, QObject* parent)
    : QObject(parent), document_(document), view_(view), remembered_(settings::brightness.read())
{
    storing_.setSingleShot(true);
    storing_.setInterval(2s);
    connect(&storing_, &QTimer::timeout, this, [this] { storeBrightness(remembered_); });
    connect(&document_, &CaseDocument::changed, this, &BrightnessMemory::followDocument);
    connect(&view_, &ui::AngiogramView::windowLevelChanged, this,
            [this](double window, double level) { keep(series_, window, level); });
}

BrightnessMemory::~BrightnessMemory()
{
    if (storing_.isActive()) {
        storeBrightness(remembered_);
    }
}

void BrightnessMemory::followDocument()
{
    if (document_.current().shown().angiogram != shown_) {
        shown_ = document_.current().shown().angiogram;
        series_.clear();   // automatic window/level of a new image is not the user's choice
        QMetaObject::invokeMethod(this, &BrightnessMemory::recall, Qt::QueuedConnection);   // when the image is shown
    }
}

void BrightnessMemory::recall()
{
    if (const auto range = rangeOf(document_.current().shown())) {
        view_.setWindowLevel(range->window(), range->level());
    }
    series_ = seriesKey(document_.current().shown());
}

std::optional<core::DisplayRange> BrightnessMemory::rangeOf(const core::View& view) const
{
    const QString series = seriesKey(view);
    for (const QString& line : remembered_) {
        const QStringList parts = line.split(QLatin1Char(' '));
        if (parts.size() == 3 && parts[0] == series) {
            const double window = parts[1].toDouble();
            const double level = parts[2].toDouble();
            return core::DisplayRange{level - 0.5 * window, level + 0.5 * window};
        }
    }
    return automaticRange(view);
}

void BrightnessMemory::keep(const core::View& view, double window, double level)
{
    keep(seriesKey(view), window, level);
}

void BrightnessMemory::keep(const QString& series, double window, double level)
{
    if (series.isEmpty()) {
        return;
    }
    const QString prefix = series + QLatin1Char(' ');
    remembered_.removeIf([&prefix](const QString& line) { return line.startsWith(prefix); });
    remembered_.prepend(prefix + QString::number(window, 'g', 9) + QLatin1Char(' ') + QString::number(level, 'g', 9));
    remembered_ = remembered_.first(std::min(remembered_.size(), keptSeries));
    storing_.start();
}

}   // namespace angiopose::app
