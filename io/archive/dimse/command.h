#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace angiopose::io {

/// Message types (PS3.7 E.1-1, field 0000,0100).
enum class DimseMessageType : std::uint16_t {
    StoreRequest = 0x0001,
    StoreResponse = 0x8001,
    GetRequest = 0x0010,
    GetResponse = 0x8010,
    FindRequest = 0x0020,
    FindResponse = 0x8020,
    MoveRequest = 0x0021,
    MoveResponse = 0x8021,
    EchoRequest = 0x0030,
    EchoResponse = 0x8030,
};

/// A DIMSE command set: a request or response without its data set.
class DimseCommand {
public:
    DimseCommand() = default;
    DimseCommand(DimseMessageType kind, std::uint16_t messageId, const std::string& sopClass);

    /// Builds the response to this request.
    DimseCommand response(std::uint16_t status) const;

    void setNumber(std::uint16_t element, std::uint16_t value) { setBytes(element, littleEndian(value)); }
    void setText(std::uint16_t element, const std::string& value, char padding = '\0');
    void setHasData() { setNumber(dataSetType, 0x0001); }

    std::optional<std::uint16_t> number(std::uint16_t element) const;
    std::string text(std::uint16_t element) const;   ///< value without its padding
    DimseMessageType kind() const { return static_cast<DimseMessageType>(number(commandField).value_or(0)); }
    std::uint16_t status() const { return number(statusField).value_or(0xffff); }
    bool hasData() const { return number(dataSetType).value_or(noData) != noData; }

    /// Encodes the command set as implicit VR little endian with its group length (PS3.7 6.3.1).
    std::string encoded() const;

    /// Decodes a command set; returns nullopt if the bytes are not a command set.
    static std::optional<DimseCommand> decode(std::string_view bytes);

    // Elements of group 0000.
    static constexpr std::uint16_t affectedSopClass = 0x0002;
    static constexpr std::uint16_t commandField = 0x0100;
    static constexpr std::uint16_t messageId = 0x0110;
    static constexpr std::uint16_t respondedMessageId = 0x0120;
    static constexpr std::uint16_t moveDestination = 0x0600;
    static constexpr std::uint16_t priority = 0x0700;
    static constexpr std::uint16_t dataSetType = 0x0800;
    static constexpr std::uint16_t statusField = 0x0900;
    static constexpr std::uint16_t errorComment = 0x0902;
    static constexpr std::uint16_t affectedSopInstance = 0x1000;
    static constexpr std::uint16_t remaining = 0x1020;
    static constexpr std::uint16_t completed = 0x1021;
    static constexpr std::uint16_t failed = 0x1022;
    static constexpr std::uint16_t warned = 0x1023;

    static constexpr std::uint16_t noData = 0x0101;

private:
    static std::string littleEndian(std::uint16_t value);
    void setBytes(std::uint16_t element, std::string value) { values_[element] = std::move(value); }

    std::map<std::uint16_t, std::string> values_;   ///< padded values, keyed by element number
};

/// Status codes of responses (PS3.7 C, PS3.4 B.2.3, C.4).
namespace dimse {
inline constexpr std::uint16_t success = 0x0000;
inline constexpr std::uint16_t pending = 0xff00;
inline constexpr std::uint16_t pendingWithWarning = 0xff01;
inline constexpr std::uint16_t suboperationsFailed = 0xb000;
inline constexpr std::uint16_t duplicateInstance = 0x0111;
inline constexpr std::uint16_t sopClassNotSupported = 0x0122;
inline constexpr std::uint16_t outOfResources = 0xa700;
inline constexpr std::uint16_t dataSetMismatch = 0xa900;
inline constexpr std::uint16_t cannotUnderstand = 0xc000;
}   // namespace dimse

/// Formats the status of a response, for example "0xA700 (no room)".
std::string statusText(const DimseCommand& response);

}   // namespace angiopose::io
