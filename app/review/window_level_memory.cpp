#include "app/review/window_level_memory.h"

#include "app/preferences/private_mode.h"
#include "app/preferences/settings.h"
#include "ui/views/angiogram_view.h"

#include <QCryptographicHash>

#include <algorithm>

namespace angiopose::app {
namespace {

using namespace std::chrono_literals;

constexpr qsizetype keptSeries = 200;

/// Returns the key of a series, hashed because settings must not identify patients.
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

/// Does nothing in private mode, because anyone who has the image could recognize its hash in the settings.
void storeWindowLevels(const QStringList& remembered)
{
    if (!isPrivate()) {
        settings::brightness.write(remembered);
    }
}

}   // namespace

WindowLevelMemory::WindowLevelMemory(const CaseDocument& document, ui::AngiogramView& view, QObject* parent)
    : QObject(parent), document_(document), view_(view), entries_(settings::brightness.read())
{
    storeTimer_.setSingleShot(true);
    storeTimer_.setInterval(2s);
    connect(&storeTimer_, &QTimer::timeout, this, [this] { storeWindowLevels(entries_); });
    connect(&document_, &CaseDocument::changed, this, &WindowLevelMemory::updateFromDocument);
    connect(&view_, &ui::AngiogramView::windowLevelChanged, this,
            [this](double window, double level) { store(series_, window, level); });
}

WindowLevelMemory::~WindowLevelMemory()
{
    if (storeTimer_.isActive()) {
        storeWindowLevels(entries_);
    }
}

void WindowLevelMemory::updateFromDocument()
{
    if (document_.current().shown().angiogram != shownRun_) {
        shownRun_ = document_.current().shown().angiogram;
        series_.clear();   // automatic window/level of a new image is not a choice of the user
        QMetaObject::invokeMethod(this, &WindowLevelMemory::restore, Qt::QueuedConnection);   // once the image is shown
    }
}

void WindowLevelMemory::restore()
{
    if (const auto range = rangeOf(document_.current().shown())) {
        view_.setWindowLevel(range->window(), range->level());
    }
    series_ = seriesKey(document_.current().shown());
}

std::optional<core::DisplayRange> WindowLevelMemory::rangeOf(const core::View& view) const
{
    const QString series = seriesKey(view);
    for (const QString& line : entries_) {
        const QStringList parts = line.split(QLatin1Char(' '));
        if (parts.size() == 3 && parts[0] == series) {
            const double window = parts[1].toDouble();
            const double level = parts[2].toDouble();
            return core::DisplayRange{level - 0.5 * window, level + 0.5 * window};
        }
    }
    return automaticRange(view);
}

void WindowLevelMemory::store(const core::View& view, double window, double level)
{
    store(seriesKey(view), window, level);
}

void WindowLevelMemory::store(const QString& series, double window, double level)
{
    if (series.isEmpty()) {
        return;
    }
    const QString prefix = series + QLatin1Char(' ');
    entries_.removeIf([&prefix](const QString& line) { return line.startsWith(prefix); });
    entries_.prepend(prefix + QString::number(window, 'g', 9) + QLatin1Char(' ') + QString::number(level, 'g', 9));
    entries_ = entries_.first(std::min(entries_.size(), keptSeries));
    storeTimer_.start();
}

}   // namespace angiopose::app
