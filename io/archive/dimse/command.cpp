#include "io/archive/dimse/command.h"

#include "io/archive/model/query.h"

namespace angiopose::io {
namespace {

void appendNumber(std::string& bytes, std::uint32_t value, int size)
{
    for (int i = 0; i < size; ++i) {
        bytes += static_cast<char>((value >> (8 * i)) & 0xffU);
    }
}

std::uint32_t numberAt(std::string_view bytes, std::size_t at, int size)
{
    std::uint32_t value = 0;
    for (int i = 0; i < size; ++i) {
        value |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[at + static_cast<std::size_t>(i)]))
                 << (8 * i);
    }
    return value;
}

void appendElement(std::string& bytes, std::uint16_t element, std::string_view value)
{
    appendNumber(bytes, 0, 2);
    appendNumber(bytes, element, 2);
    appendNumber(bytes, static_cast<std::uint32_t>(value.size()), 4);
    bytes += value;
}

}   // namespace

DimseCommand::DimseCommand(DimseMessageType kind, std::uint16_t id, const std::string& sopClass)
{
    setText(affectedSopClass, sopClass);
    setNumber(commandField, static_cast<std::uint16_t>(kind));
    setNumber(messageId, id);
    setNumber(dataSetType, noData);
}

DimseCommand DimseCommand::response(std::uint16_t status) const
{
    DimseCommand answer;
    answer.setText(affectedSopClass, text(affectedSopClass));
    answer.setNumber(commandField, static_cast<std::uint16_t>(number(commandField).value_or(0) | 0x8000U));
    answer.setNumber(respondedMessageId, number(messageId).value_or(0));
    answer.setNumber(dataSetType, noData);
    answer.setNumber(statusField, status);
    if (values_.contains(affectedSopInstance)) {
        answer.setText(affectedSopInstance, text(affectedSopInstance));
    }
    return answer;
}

void DimseCommand::setText(std::uint16_t element, const std::string& value, char padding)
{
    setBytes(element, value.size() % 2 == 0 ? value : value + padding);
}

std::optional<std::uint16_t> DimseCommand::number(std::uint16_t element) const
{
    const auto found = values_.find(element);
    if (found == values_.end() || found->second.size() < 2) {
        return std::nullopt;
    }
    return static_cast<std::uint16_t>(numberAt(found->second, 0, 2));
}

std::string DimseCommand::text(std::uint16_t element) const
{
    const auto found = values_.find(element);
    if (found == values_.end()) {
        return {};
    }
    std::string value = found->second;
    value.erase(value.find_last_not_of(std::string_view(" \0", 2)) + 1);
    return value;
}

std::string DimseCommand::encoded() const
{
    std::string elements;
    for (const auto& [element, value] : values_) {
        appendElement(elements, element, value);
    }
    std::string length, bytes;
    appendNumber(length, static_cast<std::uint32_t>(elements.size()), 4);
    appendElement(bytes, 0x0000, length);
    return bytes + elements;
}

std::optional<DimseCommand> DimseCommand::decode(std::string_view bytes)
{
    DimseCommand command;
    while (!bytes.empty()) {
        if (bytes.size() < 8 || numberAt(bytes, 0, 2) != 0) {
            return std::nullopt;
        }
        const auto element = static_cast<std::uint16_t>(numberAt(bytes, 2, 2));
        const std::size_t length = numberAt(bytes, 4, 4);
        bytes.remove_prefix(8);
        if (length > bytes.size()) {
            return std::nullopt;
        }
        command.values_[element] = std::string(bytes.substr(0, length));
        bytes.remove_prefix(length);
    }
    return command.values_.contains(commandField) ? std::optional(command) : std::nullopt;
}

std::string DimseCommand::littleEndian(std::uint16_t value)
{
    std::string bytes;
    appendNumber(bytes, value, 2);
    return bytes;
}

std::string statusText(const DimseCommand& response)
{
    const std::string comment = response.text(DimseCommand::errorComment);
    return statusText(response.status()) + (comment.empty() ? "" : " (" + comment + ")");
}

}   // namespace angiopose::io
