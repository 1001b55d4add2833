#include "app/archive/port_security.h"

#include "app/archive/archive_habits.h"
#include "ui/archive/port_dialog.h"
#include "ui/archive/transfer_line.h"
#include "ui/words/message_text.h"

namespace angiopose::app {
namespace {

ui::PortEntry rememberedEntry()
{
    return {settings::receiveCallers.read(),     settings::receiveHosts.read(),       settings::receiveTls.read(),
            settings::receiveAuthorities.read(), settings::receiveCertificate.read(), settings::receiveKey.read()};
}

std::vector<std::string> listedIn(const QString& typed)
{
    std::vector<std::string> listed;
    for (const QString& each : typed.split(u',', Qt::SkipEmptyParts)) {
        if (const QString value = each.trimmed(); !value.isEmpty()) {
            listed.push_back(value.toStdString());
        }
    }
    return listed;
}

io::ReceiverOptions optionsOf(const ui::PortEntry& entry)
{
    io::ReceiverOptions options;
    options.titles = listedIn(entry.titles);
    options.hosts = listedIn(entry.hosts);
    options.isTls = entry.isTls;
    options.tls = {entry.caFile.toStdString(), entry.certificateFile.toStdString(), entry.keyFile.toStdString()};
    return options;
}

}   // namespace

io::ReceiverOptions receiverOptions(int port, const QString& title)
{
    io::ReceiverOptions options = optionsOf(rememberedEntry());
    options.port = port;
    options.ownTitle = title.toStdString();
    return options;
}

PortSecurity::PortSecurity(QWidget& dialogParent, QObject* parent) : QObject(parent), dialogParent_(dialogParent) {}

void PortSecurity::ask()
{
    dialog_ = new ui::PortDialog(rememberedEntry(), &dialogParent_);
    connect(dialog_, &ui::PortDialog::saveRequested, this, &PortSecurity::save);
    dialog_->open();
}

void PortSecurity::save(const ui::PortEntry& entry)
{
    if (const auto checked = io::checkReceiver(optionsOf(entry)); !checked) {
        dialog_->line().showProblem(ui::messageText(checked.error().message));
        return;
    }
    settings::receiveCallers.write(entry.titles);
    settings::receiveHosts.write(entry.hosts);
    settings::receiveTls.write(entry.isTls);
    settings::receiveAuthorities.write(entry.caFile);
    settings::receiveCertificate.write(entry.certificateFile);
    settings::receiveKey.write(entry.keyFile);
    dialog_->accept();
}

}   // namespace angiopose::app
