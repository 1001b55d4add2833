#include "app/archive/archive_list.h"

#include "ui/words/message_text.h"

#include <algorithm>
#include <memory>

namespace angiopose::app {

void ArchiveList::read()
{
    const auto found = std::make_shared<io::ArchiveSettings>();
    files_.run(
        [found]() -> core::Result<QString> {
            const std::string path = io::defaultArchiveSettingsFile();
            auto settings = io::readArchiveSettings(path);
            if (!settings) {
                return settings.error();
            }
            *found = std::move(settings).value();
            return QString::fromStdString(path);
        },
        [this, found](const core::Result<QString>& outcome) {
            if (!outcome) {
                emit failed(ui::messageText(outcome.error().message));
                return;
            }
            settings_ = *found;
            emit changed();
        });
}

void ArchiveList::change(Change change, Callback callback)
{
    const auto changedSettings = std::make_shared<io::ArchiveSettings>();
    files_.run(
        [changedSettings, change = std::move(change)]() -> core::Result<QString> {
            const std::string path = io::defaultArchiveSettingsFile();
            auto settings = io::readArchiveSettings(path);
            if (!settings) {
                return settings.error();
            }
            *changedSettings = std::move(settings).value();
            if (auto done = change(*changedSettings); !done) {
                return done.error();
            }
            if (auto written = io::writeArchiveSettings(*changedSettings, path); !written) {
                return written.error();
            }
            return QString::fromStdString(path);
        },
        [this, changedSettings, callback = std::move(callback)](const core::Result<QString>& outcome) {
            if (outcome) {
                settings_ = *changedSettings;
            }
            if (callback) {
                callback(outcome ? std::nullopt : std::optional(outcome.error().message));
            }
            if (outcome) {
                emit changed();
            }
        });
}

QStringList ArchiveList::names() const
{
    QStringList names;
    for (const io::ArchiveNode& node : settings_.nodes) {
        names << QString::fromStdString(node.name);
    }
    return names;
}

std::optional<io::ArchiveNode> ArchiveList::node(const QString& name) const
{
    const auto found = std::ranges::find(settings_.nodes, name.toStdString(), &io::ArchiveNode::name);
    return found == settings_.nodes.end() ? std::nullopt : std::optional(*found);
}

}   // namespace angiopose::app
